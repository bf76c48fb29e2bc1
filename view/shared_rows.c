// SPDX-License-Identifier: MIT
// shared_rows.c -- fills an OpenGL buffer with the rows that a renderer draws: the device writes them, or the host
// copies them.
#include "view/shared_rows.h"
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool share_context(scree_opengl* opengl)
{
	if (!epoxy_has_egl() || eglGetCurrentContext() == EGL_NO_CONTEXT)
		return false;
	*opengl = (scree_opengl){SCREE_WINDOW_EGL, eglGetCurrentContext(), eglGetCurrentDisplay()};
	return true;
}

// Finds the device of a world in the list of all devices. Returns false if the list does not contain the device, or if
// memory is short.
static bool find_device(const scree_world* world, scree_device* device)
{
	int count = 0;
	scree_devices_get(NULL, 0, &count);
	scree_device* devices = calloc((size_t)count + 1, sizeof *devices);
	if (!devices || scree_devices_get(devices, count, &count) != SCREE_OK)
		count = 0;
	bool found = false;
	for (int k = 0; k < count && !found; ++k)
	{
		*device = devices[k];
		found = strcmp(device->name, scree_world_get_device(world)) == 0;
	}
	free(devices);
	return found;
}

void share_open(Share* share, scree_world* world, bool copy)
{
	*share = (Share){.world = world, .copy = copy, .exported.files = {-1, -1}};
}

static void drop_buffer(Share* share)
{
	scree_world_unshare(share->world);
	glDeleteBuffers(1, &share->buffer);
	if (share->memory)
		glDeleteMemoryObjectsEXT(1, &share->memory);
	exported_memory_drop(&share->exported);
	share->buffer = share->memory = 0;
	share->capacity = 0;
}

void share_close(Share* share)
{
	drop_buffer(share);
	*share = (Share){.exported.files = {-1, -1}};
}

// Creates the buffer in memory that Vulkan allocates and that OpenGL and OpenCL import. Returns false and writes a
// sentence on failure.
static bool share_memory(Share* share, size_t bytes)
{
	char* sentence = share->sentence;
	const size_t size = sizeof share->sentence;
	scree_device device;
	uint8_t uuid[16] = {0};
	if (epoxy_has_gl_extension("GL_EXT_memory_object_fd"))
		glGetUnsignedBytei_vEXT(GL_DEVICE_UUID_EXT, 0, uuid);
	if (!find_device(share->world, &device) || memcmp(uuid, device.uuid, sizeof uuid) != 0)
	{
		snprintf(sentence, size, "OpenGL draws on another device, or has no GL_EXT_memory_object_fd");
		return false;
	}
	ExportedMemory* memory = &share->exported;
	if (!exported_memory_make(memory, uuid, bytes, sentence, size))
		return false;
	if (scree_world_share_memory(share->world, memory->files[0], bytes) != SCREE_OK)
	{
		snprintf(sentence, size, "%s", scree_error());
		return false;
	}
	memory->files[0] = -1; // OpenCL now owns the file descriptor
	while (glGetError() != GL_NO_ERROR)
		; // removes errors of earlier calls of OpenGL
	glCreateMemoryObjectsEXT(1, &share->memory);
	glImportMemoryFdEXT(share->memory, memory->allocated, GL_HANDLE_TYPE_OPAQUE_FD_EXT, memory->files[1]);
	GLenum error = glGetError();
	if (!error)
	{
		memory->files[1] = -1; // OpenGL now owns the file descriptor
		glBufferStorageMemEXT(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, share->memory, 0);
		error = glGetError();
	}
	if (error)
		snprintf(sentence, size, "OpenGL does not take memory from outside: error 0x%x", error);
	return !error;
}

static bool share_opengl(Share* share, size_t bytes)
{
	glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_DRAW);
	glFinish(); // the buffer must exist before OpenCL uses it
	if (scree_world_share_opengl(share->world, share->buffer, bytes) == SCREE_OK)
		return true;
	snprintf(share->sentence, sizeof share->sentence, "%s", scree_error());
	return false;
}

// Creates a buffer with room for additional rows. If sharing fails, selects copying.
static void make_buffer(Share* share)
{
	int capacity = share->count + share->count / 2 + 1024;
	size_t bytes = (size_t)capacity * sizeof(scree_render_row);
	for (;;)
	{
		drop_buffer(share);
		glGenBuffers(1, &share->buffer);
		glBindBuffer(GL_ARRAY_BUFFER, share->buffer);
		if (share->how == SCREE_SHARING_COPIED)
			glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, NULL, GL_STREAM_DRAW);
		if (share->how == SCREE_SHARING_COPIED || (share->how == SCREE_SHARING_OPENGL && share_opengl(share, bytes)) ||
		    (share->how == SCREE_SHARING_MEMORY && share_memory(share, bytes)))
			break;
		share->how = SCREE_SHARING_COPIED;
	}
	share->capacity = capacity;
}

// Copies the rows from the device into the mapped buffer.
static scree_status copy(Share* share)
{
	glBindBuffer(GL_ARRAY_BUFFER, share->buffer);
	GLsizeiptr bytes = (GLsizeiptr)share->count * (GLsizeiptr)sizeof(scree_render_row);
	if (bytes == 0)
		return SCREE_OK;
	scree_render_row* rows =
	    glMapBufferRange(GL_ARRAY_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
	if (!rows)
	{
		snprintf(share->sentence, sizeof share->sentence, "OpenGL has no memory for %d rows", share->count);
		return SCREE_ERROR_OUT_OF_MEMORY;
	}
	scree_status status = scree_world_get_render_rows(share->world, rows, share->count, &share->count);
	glUnmapBuffer(GL_ARRAY_BUFFER);
	return status;
}

scree_status share_update(Share* share)
{
	scree_status status = scree_world_get_render_rows(share->world, NULL, 0, &share->count);
	if (status != SCREE_OK)
		return status;
	const char* device = scree_world_get_device(share->world);
	bool moved = strcmp(share->device, device) != 0;
	if (moved)
	{
		snprintf(share->device, sizeof share->device, "%s", device);
		share->how = share->copy ? SCREE_SHARING_COPIED : scree_world_get_sharing(share->world);
	}
	if (moved || share->count > share->capacity)
		make_buffer(share);
	if (share->how == SCREE_SHARING_COPIED)
		return copy(share);
	glFinish(); // OpenGL must finish drawing the rows before the device changes them
	status = scree_world_write_render_rows(share->world, &share->count);
	if (status == SCREE_ERROR_INVALID)
	{
		// the world has moved to another device and back, which ends the sharing
		make_buffer(share);
		status = share->how == SCREE_SHARING_COPIED ? copy(share)
		                                            : scree_world_write_render_rows(share->world, &share->count);
	}
	return status;
}

scree_status share_put(Share* share, const scree_render_row* rows, int count)
{
	if (!share->buffer)
		glGenBuffers(1, &share->buffer);
	share->how = SCREE_SHARING_COPIED;
	share->count = share->capacity = count;
	glBindBuffer(GL_ARRAY_BUFFER, share->buffer);
	glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)count * sizeof *rows), rows, GL_STREAM_DRAW);
	return SCREE_OK;
}

const char* share_error(const Share* share) { return *share->sentence ? share->sentence : scree_error(); }
