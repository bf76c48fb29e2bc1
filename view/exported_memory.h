// SPDX-License-Identifier: MIT
// exported_memory.h -- allocates device memory through Vulkan; OpenCL and OpenGL import this memory.
#ifndef EXPORTED_MEMORY_H
#define EXPORTED_MEMORY_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct
{
	int files[2];     // file descriptors of the memory, for OpenCL and OpenGL; -1: closed, or owned by the importer
	size_t allocated; // bytes; at least the requested size
	void* allocation; // VkDeviceMemory
} ExportedMemory;

// Allocates memory on the device with this UUID. Only one thread of the process may call this function. Returns false
// and writes a sentence on failure.
bool exported_memory_make(ExportedMemory* memory, const uint8_t uuid[16], size_t bytes, char* sentence, size_t size);

// Frees the memory. OpenCL and OpenGL must have released it.
void exported_memory_drop(ExportedMemory* memory);

#endif
