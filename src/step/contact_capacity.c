// SPDX-License-Identifier: MIT
// contact_capacity.c -- computes the contact limit, and the error message of a step that exceeds it.
//
// If n bodies are at one point, they have about n^2 / 2 pairs: 22,000 boxes have 242 million, each of 300 bytes.
#include "step/contact_capacity.h"
#include "platform/error.h"
#include <stdio.h>
#include <stdlib.h>

#define CONTACTS_A_COLLIDABLE 32      // default contacts per collidable; heaps have 3, dense heaps of long bodies 20
#define LEAST_LIMIT           2000000 // minimum default limit: 600 MB, enough for 2,000 bodies at one point

int contact_limit(const StepRequest* request)
{
	if (request->contact_limit > 0)
		return request->contact_limit;
	int64_t limit = (int64_t)CONTACTS_A_COLLIDABLE * request->collidables;
	limit = limit < LEAST_LIMIT ? LEAST_LIMIT : limit;
	return limit < MAX_CONTACTS ? (int)limit : MAX_CONTACTS;
}

static int compare_words(const void* a, const void* b)
{
	uint64_t x = *(const uint64_t*)a, y = *(const uint64_t*)b;
	return (x > y) - (x < y);
}

static bool is_empty(Float4 box) { return !(box.x <= box.z); }

static uint64_t cell_of(float x, float cell)
{
	double at = (double)x / (double)cell;
	at = at > -1e9 ? at < 1e9 ? at : 1e9 : -1e9;
	return (uint64_t)(int64_t)(at + 1e9);
}

static uint64_t key_of(Float4 box, float cell)
{
	return cell_of(0.5f * (box.x + box.z), cell) << 32 | cell_of(0.5f * (box.y + box.w), cell);
}

// m: Returns the median of width + height of finite boxes, or 1 if there are none. words: room for `count` entries.
static float usual_size(const Float4* boxes, int count, uint64_t* words)
{
	int found = 0;
	for (int k = 0; k < count; ++k)
	{
		float size = boxes[k].z - boxes[k].x + (boxes[k].w - boxes[k].y);
		if (!is_empty(boxes[k]) && size < 1e30f)
			words[found++] = float_word(size); // floats that are not negative have the order of their bits
	}
	qsort(words, (size_t)found, sizeof *words, compare_words);
	return found > 0 ? bits_float((int)words[found / 2]) : 1.0f;
}

// Finds the cell of a grid with the most centers of boxes. *place: mean of these centers. Returns the number of boxes
// that contain this point. keys: room for `count` entries.
static int fullest_place(const Float4* boxes, int count, uint64_t* keys, scree_vec* place)
{
	float cell = usual_size(boxes, count, keys);
	int found = 0, most = 0, length = 0;
	for (int k = 0; k < count; ++k)
		if (!is_empty(boxes[k]))
			keys[found++] = key_of(boxes[k], cell);
	qsort(keys, (size_t)found, sizeof *keys, compare_words);
	uint64_t key = 0;
	for (int k = 0; k < found; ++k)
	{
		length = k > 0 && keys[k] == keys[k - 1] ? length + 1 : 1;
		key = length > most ? keys[k] : key;
		most = length > most ? length : most;
	}

	double x = 0, y = 0;
	for (int k = 0; k < count; ++k)
		if (!is_empty(boxes[k]) && key_of(boxes[k], cell) == key)
		{
			x += 0.5 * (double)(boxes[k].x + boxes[k].z) / most;
			y += 0.5 * (double)(boxes[k].y + boxes[k].w) / most;
		}
	*place = (scree_vec){(float)x, (float)y};
	int over = 0;
	for (int k = 0; k < count; ++k)
		over += boxes[k].x <= place->x && place->x <= boxes[k].z && boxes[k].y <= place->y && place->y <= boxes[k].w;
	return over;
}

scree_status contact_limit_fail(Pipeline* pipeline, const Step* step)
{
	Backend* b = pipeline->backend;
	int count = step->collidables, contacts = pipeline->counters.alive, pairs = pipeline->counters.pairs,
	    limit = step->contact_limit;
	Float4* boxes = scree_allocate((size_t)count * sizeof *boxes);
	uint64_t* keys = scree_allocate((size_t)count * sizeof *keys);
	scree_status status = boxes && keys ? b->f->read(b, POOL_box, 0, count, boxes) : SCREE_OK;
	char where[96] = "";
	if (boxes && keys && status == SCREE_OK)
	{
		scree_vec place;
		int over = fullest_place(boxes, count, keys, &place);
		snprintf(where, sizeof where, "; most crowded is (%.2f, %.2f), where %d boxes overlap", (double)place.x,
		         (double)place.y, over);
	}
	scree_release(boxes);
	scree_release(keys);
	if (status != SCREE_OK)
		return status;
	return fail(SCREE_ERROR_CONTACT_LIMIT,
	            "scree_world_step: %d contacts and %s%d new pairs are more than contact_limit, %d, allows%s", contacts,
	            pairs > limit ? "at least " : "", pairs, limit, where);
}
