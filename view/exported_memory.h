// SPDX-License-Identifier: MIT
// exported_memory.h -- device memory that OpenCL and OpenGL both import, allocated through Vulkan.
#ifndef EXPORTED_MEMORY_H
#define EXPORTED_MEMORY_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct
{
	int files[2];     // file descriptors, one for each importer; -1: closed, or owned by the importer
	size_t allocated; // bytes
	void* allocation; // memory of Vulkan
} ExportedMemory;

// Allocates memory on the device with this UUID. Only one thread may call it. Returns false and writes a sentence on
// failure.
bool exported_memory_make(ExportedMemory* memory, const uint8_t uuid[16], size_t bytes, char* sentence, size_t size);

// Frees the memory. Both importers must have released it.
void exported_memory_drop(ExportedMemory* memory);

#endif
