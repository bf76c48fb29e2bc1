// SPDX-License-Identifier: MIT
// share.h -- the rows that a renderer draws, in a buffer of OpenGL: left there by the device, or copied.
//
// All of it wants a current context. docs/share.md tells which drivers take which way.
#ifndef SHARE_H
#define SHARE_H
#include "scree/scree.h"

typedef struct // memory of a device, for two that import it
{
	int files[2];     // descriptors; -1 for one that is not ours any more
	size_t allocated; // bytes
	void* allocation; // of Vulkan
} ExportedMemory;

typedef struct
{
	scree_world* world;
	bool copy;          // is wanted, also where there is a better way
	char device[160];   // of the world, when the way was chosen
	scree_sharing how;  // now
	char sentence[256]; // why not better, where the device offers better; else empty. Whoever has told may clear it
	unsigned buffer;    // of OpenGL, holds a scree_render_row a row; another one after the world has grown
	unsigned memory;    // object of OpenGL that the buffer lies in, 0 for none
	ExportedMemory exported;
	int room, count; // rows: there is room for, there are
} Share;

// The current context, for scree_world_def.opengl: false when it is not one of EGL.
bool share_context(scree_opengl* opengl);

// copy wants the copy even where there is a better way. Nothing is allocated yet.
void share_open(Share* share, scree_world* world, bool copy);

// Brings the rows up to date, when everything that was drawn from them is done. Chooses the way anew when the world has
// moved to another device.
scree_status share_update(Share* share);

// What was wrong when share_update has failed.
const char* share_trouble(const Share* share);

void share_close(Share* share);

// Allocates memory on the device with this uuid through Vulkan. From one thread. False leaves a sentence.
bool exported_memory_make(ExportedMemory* memory, const uint8_t uuid[16], size_t bytes, char* sentence, size_t size);
// When those that imported it have let go.
void exported_memory_drop(ExportedMemory* memory);

#endif
