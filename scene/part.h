// SPDX-License-Identifier: MIT
// part.h -- reads the collidables of a block's items: attribute, pose in the body, filter.
#ifndef PART_H
#define PART_H
#include "scene/format.h"

#define MAX_PARTS 65536 // maximum number of collidables of one body

typedef struct // attribute that is selected from a list
{
	int* attributes; // positions in Scene.attributes
	int count;
	Number choose; // position in the list; used only if the list has more than one attribute
} Choice;

typedef struct // collidable that each item of a block has
{
	Choice choice;
	scree_collidable_def def; // values that are equal in all items
	FormatNumbers numbers;
} Part;

typedef struct // all collidables of each item
{
	Part* list;
	int count;
	bool simple; // true: a single collidable, at the body's origin
} Parts;

// Reads the collidables of an entry of "bodies", or the only collidable of an entry of "collidables". The caller frees
// the parts, also on failure.
bool parts_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, bool bodies,
                Parts* parts);
void parts_free(Parts* parts);

#endif
