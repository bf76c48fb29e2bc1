// SPDX-License-Identifier: MIT
// page_rows.c -- implements shared_rows.h for WebGL: copies the rows through the host, because WebGL can neither map
// nor share buffers.
#include "view/opengl.h"
#include "view/shared_rows.h"
#include <stdio.h>
#include <stdlib.h>

void share_open(Share* share, scree_world* world, bool copy)
{
	*share = (Share){.world = world, .copy = copy, .how = SCREE_SHARING_COPIED};
}

void share_close(Share* share)
{
	glDeleteBuffers(1, &share->buffer);
	free(share->rows);
	*share = (Share){0};
}

// Allocates memory and a buffer with room for additional rows. Returns false if memory is short.
static bool make_room(Share* share)
{
	int capacity = share->count + share->count / 2 + 1024;
	scree_render_row* rows = realloc(share->rows, (size_t)capacity * sizeof *rows);
	if (!rows)
		return false;
	if (!share->buffer)
		glGenBuffers(1, &share->buffer);
	glBindBuffer(GL_ARRAY_BUFFER, share->buffer);
	glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)capacity * (GLsizeiptr)sizeof *rows, NULL, GL_STREAM_DRAW);
	share->rows = rows;
	share->capacity = capacity;
	return true;
}

// Makes room for Share.count rows.
static scree_status ensure_room(Share* share)
{
	if (share->count <= share->capacity || make_room(share))
		return SCREE_OK;
	snprintf(share->sentence, sizeof share->sentence, "there is no memory for %d rows", share->count);
	return SCREE_ERROR_OUT_OF_MEMORY;
}

scree_status share_update(Share* share)
{
	scree_status status = scree_world_get_render_rows(share->world, NULL, 0, &share->count);
	if (status == SCREE_OK)
		status = ensure_room(share);
	if (status != SCREE_OK)
		return status;
	status = scree_world_get_render_rows(share->world, share->rows, share->capacity, &share->count);
	glBindBuffer(GL_ARRAY_BUFFER, share->buffer);
	if (status == SCREE_OK && share->count > 0)
		glBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)share->count * (GLsizeiptr)sizeof *share->rows, share->rows);
	return status;
}

scree_status share_put(Share* share, const scree_render_row* rows, int count)
{
	share->count = count;
	scree_status status = ensure_room(share);
	glBindBuffer(GL_ARRAY_BUFFER, share->buffer);
	if (status == SCREE_OK)
		glBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)count * (GLsizeiptr)sizeof *rows, rows);
	return status;
}

const char* share_error(const Share* share) { return *share->sentence ? share->sentence : scree_error(); }
