// SPDX-License-Identifier: MIT
// shared_rows.h -- the rows that a renderer draws, in an OpenGL buffer: written by the device, or copied through the
// host.
//
// All functions need a current OpenGL context. docs/share.md lists the drivers that support each way.
#ifndef SHARED_ROWS_H
#define SHARED_ROWS_H
#include "scree/scree.h"
#include "view/exported_memory.h"

typedef struct
{
	scree_world* world;
	bool copy;         // copy even if sharing works
	char device[160];  // device of the world when how was selected
	scree_sharing how; // the current way
	char sentence
	    // reason for copying rows that the device could share; empty if there is none. The reader may clear it
	    [256];
	unsigned buffer; // OpenGL buffer of scree_render_row; replaced when the world grows
	unsigned memory; // OpenGL memory object of the buffer, 0 for none
	ExportedMemory exported;
	int capacity, count;    // rows that fit into the buffer, rows that are drawn
	scree_render_row* rows; // host copy of the rows in a page; null where OpenGL maps its buffers
} Share;

// Fills opengl with the current context, for scree_world_def.opengl. Returns false if it is not an EGL context.
bool share_context(scree_opengl* opengl);

// Initializes the struct; allocates nothing yet. copy: copy even if sharing works.
void share_open(Share* share, scree_world* world, bool copy);

// Updates the rows after OpenGL has finished drawing the old ones. If the world has moved to another device, it selects
// sharing or copying again.
scree_status share_update(Share* share);

// Returns the reason for the last failure of share_update.
const char* share_error(const Share* share);

void share_close(Share* share);

#endif
