// SPDX-License-Identifier: MIT
// marks.h -- the plainest picture of a world: every row a rectangle or a disk, as large as its shape.
#ifndef MARKS_H
#define MARKS_H
#include "scree/scree.h"

typedef struct // names of OpenGL
{
	unsigned program, vertices, sizes, table;
	int view; // uniform
} Marks;

// Takes the attributes of a world by the index of their handles. Returns null or why it cannot.
const char* marks_open(Marks* marks, const scree_attribute_def* attributes, int count);

// Draws count rows of a buffer over what there is; view is what the picture shows, m.
void marks_draw(const Marks* marks, unsigned buffer, int count, scree_box view);

void marks_close(Marks* marks);

#endif
