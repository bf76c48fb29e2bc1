// SPDX-License-Identifier: MIT
// shared_rows.h -- fills an OpenGL buffer with the rows that a renderer draws: the device writes them, or the host
// copies them.
//
// All functions need a current OpenGL context. docs/manual/share.md lists the drivers that support each kind of sharing.
#ifndef SHARED_ROWS_H
#define SHARED_ROWS_H
#include "scree/scree.h"
#include "view/exported_memory.h"

typedef struct
{
	scree_world* world;
	bool copy;          // true: the rows are copied even if sharing works
	char device[160];   // device of the world at the time when sharing or copying was selected
	scree_sharing how;  // kind of sharing, or copying
	char sentence[256]; // reason for copying rows instead of sharing them, or empty; the caller may clear it
	unsigned buffer;    // OpenGL buffer of scree_render_row; replaced when the world grows
	unsigned memory;    // OpenGL memory object of the buffer; 0: none
	ExportedMemory exported;
	int capacity, count;    // number of rows that fit into the buffer; number of rows in the world, which are drawn
	scree_render_row* rows; // host copy of the rows, in a page; null if OpenGL maps its buffers
} Share;

// Sets *opengl to the current context, for scree_world_def.opengl. Returns false if this is not an EGL context.
bool share_context(scree_opengl* opengl);

// Initializes the struct and allocates nothing. copy: the rows are copied even if sharing works.
void share_open(Share* share, scree_world* world, bool copy);

// Updates the rows after OpenGL has finished drawing the old rows. If the world has moved to another device, selects
// sharing or copying again.
scree_status share_update(Share* share);

// Fills the buffer with `count` rows of the host instead of those of the world.
scree_status share_put(Share* share, const scree_render_row* rows, int count);

// Returns the error message of the last share_update that failed.
const char* share_error(const Share* share);

void share_close(Share* share);

#endif
