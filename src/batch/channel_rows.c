// SPDX-License-Identifier: MIT
// channel_rows.c -- allocates the rows of a list of channels, checks those of inputs, and converts rows to metres and back.
#include "batch/channel_rows.h"
#include "platform/error.h"
#include "world/objects/mass.h"
#include "world/units/scale.h"
#include <stdio.h>
#include <string.h>

_Static_assert((int)CHANNEL_LISTS < PINNED_MOST, "while the memory of a list is replaced, one more block exists");

scree_status channel_rows_open(ChannelSet* set, const char* function, int worlds, Backend* pins)
{
	size_t bytes = sizeof(float) * (size_t)worlds * (size_t)set->columns;
	void* memory = NULL;
	set->owned = true;
	set->pins = pins && pins->f->pin ? pins : NULL;
	if (set->pins)
		TRY(pins->f->pin(pins, bytes, &memory));
	else
		memory = scree_allocate(bytes);
	set->memory = memory;
	if (!memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %zu bytes", function, bytes);
	memset(memory, 0, bytes);
	return SCREE_OK;
}

void channel_rows_close(ChannelSet* set)
{
	if (set->pins)
		set->pins->f->unpin(set->pins, set->memory);
	else if (set->owned)
		scree_release(set->memory);
	set->memory = NULL;
	set->owned = false;
	set->pins = NULL;
}

static void convert(const ChannelSet* set, float* row, Direction direction)
{
	for (int k = 0; k < set->columns && set->unit != 0.0; ++k)
		units_scale(set->unit, (char*)(row + k), 1, set->rules[k].power, direction);
}

// Returns whether rows are in range. The bounds of BOUND_ROWS rows are adjacent, and each of BOUND_ROWS results has its own
// values, so that compilers use vectors: one result for all values took three times as long.
static bool rows_are_valid(const ChannelSet* set, const float* rows, int count)
{
	size_t values = (size_t)count * (size_t)set->columns, period = (size_t)(BOUND_ROWS * set->columns), at = 0;
	int wrong[BOUND_ROWS] = {0}, any = 0;
	for (; at + period <= values; at += period)
		for (size_t k = 0; k < period; k += BOUND_ROWS)
			for (size_t n = 0; n < BOUND_ROWS; ++n)
			{
				float x = rows[at + k + n];
				wrong[n] |= !(x >= set->least[k + n]) | !(x <= set->most[k + n]);
			}
	for (size_t k = 0; at + k < values; ++k)
		any |= !(rows[at + k] >= set->least[k]) | !(rows[at + k] <= set->most[k]);
	for (size_t n = 0; n < BOUND_ROWS; ++n)
		any |= wrong[n];
	return !any;
}

// Returns whether the inertias and the switches of rows in range are allowed.
static bool parts_are_valid(const ChannelSet* set, const float* rows, int count)
{
	bool wrong = false;
	for (int k = 0; k < set->columns && set->parts; ++k)
		for (int n = 0; n < count && set->rules[k].part > PART_POSE; ++n)
		{
			float x = rows[(size_t)n * (size_t)set->columns + (size_t)k];
			wrong |= x != 0.0f && (set->rules[k].part == PART_SWITCH ? x != 1.0f : x < LEAST_INERTIA);
		}
	return !wrong;
}

scree_status channels_check_row(const ChannelSet* set, const char* function, const float* row, int world)
{
	char name[48];
	snprintf(name, sizeof name, "inputs of world %d", world);
	for (int k = 0; k < set->columns; ++k)
	{
		ArgumentPlace at = {function, name, k};
		float least = set->rules[k].least, most = set->rules[k].most;
		TRY(check_real(at, "", row[k], least, most));
		if (set->rules[k].part == PART_INERTIA && row[k] != 0.0f)
			TRY(check_real(at, " (when it is not 0)", row[k], LEAST_INERTIA, most));
		if (set->rules[k].part == PART_SWITCH && row[k] != 0.0f && row[k] != 1.0f)
			return refuse(SCREE_ERROR_INVALID, at, "", "is %s, must be 0 or 1", decimal(row[k]).text);
		if (set->rules[k].part != PART_POSE)
			continue;
		scree_pose pose = {{row[k], row[k + 1]}, {row[k + 2], row[k + 3]}};
		TRY(check_pose(at, "", &pose));
	}
	return SCREE_OK;
}

scree_status channels_check(const ChannelSet* set, const char* function, const float* rows, int first, int count,
                            const uint8_t* mask)
{
	const float* begin = rows + (size_t)first * (size_t)set->columns;
	if (!set->poses && set->unit == 0.0 && !mask && rows_are_valid(set, begin, count) &&
	    parts_are_valid(set, begin, count))
		return SCREE_OK;
	for (int k = first; k < first + count; ++k)
	{
		const float* row = rows + (size_t)k * (size_t)set->columns;
		float metres[MOST_COLUMNS];
		if (mask && !mask[k])
			continue;
		if (set->unit != 0.0)
		{
			memcpy(metres, row, sizeof(float) * (size_t)set->columns);
			convert(set, metres, TO_METRES);
			row = metres;
		}
		TRY(channels_check_row(set, function, row, k));
	}
	return SCREE_OK;
}

void channels_put(const ChannelSet* set, float* to, const float* from)
{
	memcpy(to, from, sizeof(float) * (size_t)set->columns);
	for (int k = 0; k < set->columns && set->poses; ++k)
	{
		if (set->rules[k].part != PART_POSE)
			continue;
		scree_pose pose = {{0.0f, 0.0f}, {to[k + 2], to[k + 3]}};
		check_pose((ArgumentPlace){"", "", ALONE}, "", &pose); // normalizes the rotation
		to[k + 2] = pose.rotation.c;
		to[k + 3] = pose.rotation.s;
	}
	convert(set, to, TO_METRES);
}

void channels_get(const ChannelSet* set, float* to, const float* from)
{
	memcpy(to, from, sizeof(float) * (size_t)set->columns);
	convert(set, to, TO_UNITS);
}
