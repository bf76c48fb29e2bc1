// SPDX-License-Identifier: MIT
// block_items.c -- runs the loops of a block, and computes the numbers of each item.
#include "scene/block_items.h"
#include <stdio.h>
#include <string.h>

// Maximum number of iterations of the outer loops. The limit of the number of items is not enough, because inner loops
// may be empty.
#define MAX_ROUNDS 50000000

typedef struct
{
	Items items;
	bool (*each)(Items* items, void* context); // function for each item; null: the items are only counted
	void* context;
	int64_t rounds, count;
	// arguments of items_count, set only for counting
	int64_t room;
	const char* owner;
	const Location* location;
} Run;

void items_open(Items* items, Reader* reader, uint64_t number)
{
	*items = (Items){.reader = reader};
	items->item = (Item){.indices = items->indices, .seed = reader->seed, .number = number};
}

bool items_fail(const Items* items, const char* path, const char* text)
{
	char where[160] = "";
	for (int k = 0; k < items->depth; ++k)
		snprintf(where + strlen(where), sizeof where - strlen(where), "%s%s = %.9g", k ? ", " : ", at ",
		         items->loops->list[k].index, items->indices[k]);
	snprintf(items->reader->sentence, SENTENCE_SIZE, "%.180s: %s: %s%s", items->reader->file, path, text, where);
	return false;
}

bool items_value(const Items* items, const Number* number, double* value)
{
	if (!number->code)
	{
		*value = number->constant;
		return true;
	}
	items->reader->work += expression_operations(number->code);
	if (items->reader->work > reader_most_work)
		return items_fail(items, number->path, "too many operations up to here");
	const char* fault = expression_evaluate(number->code, &items->item, value);
	char must[80], text[200];
	if (fault)
	{
		snprintf(text, sizeof text, "\"%.60s\": %s", number->text, fault);
		return items_fail(items, number->path, text);
	}
	fault = range_fault(number->range, *value, must, sizeof must);
	if (fault)
	{
		snprintf(text, sizeof text, "\"%.60s\" is %.9g, %s", number->text, *value, fault);
		return items_fail(items, number->path, text);
	}
	return true;
}

bool items_vec(const Items* items, const Number pair[2], scree_vec* vec)
{
	double x, y;
	if (!items_value(items, &pair[0], &x) || !items_value(items, &pair[1], &y))
		return false;
	*vec = (scree_vec){(float)x, (float)y};
	return true;
}

bool items_store(const Items* items, const FormatNumbers* numbers, void* item)
{
	for (int k = 0; k < numbers->count; ++k)
	{
		double value;
		if (!items_value(items, &numbers->list[k].number, &value))
			return false;
		format_store(item, numbers->list[k].offset, numbers->list[k].store, value);
	}
	return true;
}

static bool run_loops(Run* run, int depth)
{
	Items* items = &run->items;
	items->depth = depth;
	if (depth == items->loops->count)
	{
		++items->reader->work;
		items->item.number = (uint64_t)run->count++;
		return !run->each || run->each(items, run->context);
	}
	const Loop* loop = &items->loops->list[depth];
	double first, end;
	// sets the number of the next item, so that random() in the range of a loop gives the same value while items are
	// counted and while they are created
	items->item.number = (uint64_t)run->count;
	if (!items_value(items, &loop->first, &first) || !items_value(items, &loop->end, &end))
		return false;
	if (!run->each && depth == items->loops->count - 1)
	{
		run->count += end > first ? (int64_t)(end - first) : 0;
		if (run->count > run->room)
			return reader_fail(items->reader, run->location, "%.9g or more items; the %s has room for %.9g",
			                   (double)run->count, run->owner, (double)run->room);
		return reader_work(items->reader, run->location, end > first ? (int64_t)(end - first) : 1);
	}
	for (double index = first; index < end; ++index)
	{
		if (!run->each && ++run->rounds > MAX_ROUNDS)
			return reader_fail(items->reader, run->location, "more than %d rounds of nested ranges", MAX_ROUNDS);
		items->indices[depth] = index;
		if (!run->each && !reader_work(items->reader, run->location, 1))
			return false;
		if (!run_loops(run, depth + 1))
			return false;
	}
	items->depth = depth;
	return true;
}

bool items_count(Reader* reader, const Location* location, const Loops* loops, const char* owner, int64_t room,
                 int64_t* count)
{
	Run run = {.room = room, .owner = owner, .location = location};
	items_open(&run.items, reader, 0);
	run.items.loops = loops;
	bool good = run_loops(&run, 0);
	*count = run.count;
	return good;
}

bool block_items_run(Reader* reader, const Loops* loops, bool (*each)(Items* items, void* context), void* context)
{
	Run run = {.each = each, .context = context};
	items_open(&run.items, reader, 0);
	run.items.loops = loops;
	return run_loops(&run, 0);
}
