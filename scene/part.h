// SPDX-License-Identifier: MIT
// part.h -- the collidables of a block's items: attribute, pose in the body, filter.
#ifndef PART_H
#define PART_H
#include "scene/format.h"

#define MAX_PARTS 65536 // collidables of one body

typedef struct // attribute that is selected from a list
{
	int* attributes; // positions in Scene.attributes
	int count;
	Number choose; // position in the list, if it has more than one
} Choice;

typedef struct // one collidable of each item
{
	Choice choice;
	scree_collidable_def def; // values that those of all items have in common
	FormatNumbers numbers;
} Part;

typedef struct // all collidables of each item
{
	Part* list;
	int count;
	bool simple; // one part, at the body's origin
} Parts;

// Reads the collidables of an entry of "bodies", or the only collidable of an entry of "collidables". The caller frees
// the parts, also on failure.
bool parts_read(Reader* reader, const Location* location, const json_t* value, const Scene* scene, bool bodies,
                Parts* parts);
void parts_free(Parts* parts);

#endif
