// SPDX-License-Identifier: MIT
// shared_rows.h -- the rows that a renderer draws, in an OpenGL buffer: written by the device, or copied through the host.
//
// All functions need a current OpenGL context. docs/share.md says which drivers support which way.
#ifndef SHARED_ROWS_H
#define SHARED_ROWS_H
#include "scree/scree.h"
#include "view/exported_memory.h"

typedef struct
{
	scree_world* world;
	bool copy;         // always copy, even where sharing works
	char device[160];  // of the world, when how was chosen
	scree_sharing how; // now
	char sentence
	    [256];       // why the rows are copied although the device can share them; else empty. The reader may clear it
	unsigned buffer; // OpenGL buffer of scree_render_row; replaced when the world grows
	unsigned memory; // OpenGL memory object of the buffer, 0 for none
	ExportedMemory exported;
	int capacity, count;    // rows: that fit into the buffer, that are drawn
	scree_render_row* rows; // copied by way of these in a page; null where OpenGL maps its buffers
} Share;

// Gets the current context for scree_world_def.opengl; false when it is not an EGL context.
bool share_context(scree_opengl* opengl);

// copy: copy even where sharing works. Allocates nothing yet.
void share_open(Share* share, scree_world* world, bool copy);

// Updates the rows after OpenGL finished drawing the old ones. Chooses between sharing and copying again when the world has
// moved to another device.
scree_status share_update(Share* share);

// Why share_update failed.
const char* share_error(const Share* share);

void share_close(Share* share);

#endif
