// SPDX-License-Identifier: MIT
// upload.c -- what the user changed on its way to the device: long runs of rows as they lie in the pools, all else as
// commands, grouped by the item that they change.
#include "world/geometry.h"
#include "world/world.h"
#include <stdlib.h>
#include <string.h>

// A shorter run of rows travels as commands: on a GPU a transfer costs as much as some hundred commands.
#define LONG_RUN 16

#define BODY_COMMANDS       5 // that make up one row
#define COLLIDABLE_COMMANDS 3

static scree_status no_memory(size_t bytes)
{
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %zu bytes of changes on their way to the device", bytes);
}

static Float4 pose_value(scree_pose pose)
{
	return make_float4(pose.position.x, pose.position.y, pose.rotation.c, pose.rotation.s);
}

// ---------------------------------------------------------------------------------------------------------------
// rows in the order of their slots
// ---------------------------------------------------------------------------------------------------------------

#define DIGIT_BITS 8
#define DIGITS     (1 << DIGIT_BITS)

typedef struct // a row on its way to the place of its slot
{
	uint32_t index, row;
} Place;

// Sorts places by their index, of which bits are set: by one digit after the other. other has room for as many.
static Place* sort_places(Place* places, Place* other, int count, uint32_t bits)
{
	for (int shift = 0; bits >> shift != 0; shift += DIGIT_BITS)
	{
		int begins[DIGITS] = {0}, sum = 0;
		for (int k = 0; k < count; ++k)
			++begins[places[k].index >> shift & (DIGITS - 1)];
		for (int digit = 0; digit < DIGITS; ++digit)
		{
			int size = begins[digit];
			begins[digit] = sum;
			sum += size;
		}
		for (int k = 0; k < count; ++k)
			other[begins[places[k].index >> shift & (DIGITS - 1)]++] = places[k];
		Place* sorted = other;
		other = places;
		places = sorted;
	}
	return places;
}

// The index with which row k of so many bytes begins.
static uint32_t row_index(const void* rows, size_t bytes, int k)
{
	uint32_t index;
	memcpy(&index, (const char*)rows + (size_t)k * bytes, sizeof index);
	return index;
}

// Memory to sort rows in, which begin with their index; 0 where they are sorted, as those of a new world are.
static size_t sort_bytes(const void* rows, int count, size_t bytes)
{
	int k = 1;
	while (k < count && row_index(rows, bytes, k - 1) < row_index(rows, bytes, k))
		++k;
	return k < count ? (size_t)count * (2 * sizeof(Place) + bytes) : 0;
}

static void sort_rows(void* rows, int count, size_t bytes, char* memory)
{
	if (sort_bytes(rows, count, bytes) == 0)
		return;
	Place *places = (Place*)memory, *other = places + count;
	char *to = rows, *from = (char*)(other + count);
	uint32_t bits = 0;
	for (int k = 0; k < count; ++k)
	{
		places[k] = (Place){row_index(rows, bytes, k), (uint32_t)k};
		bits |= places[k].index;
	}
	memcpy(from, rows, (size_t)count * bytes);
	places = sort_places(places, other, count, bits);
	for (int k = 0; k < count; ++k)
		memcpy(to + (size_t)k * bytes, from + places[k].row * bytes, bytes);
}

// Both lists of rows.
static scree_status sort_pending(scree_world* world)
{
	Edits* p = &world->edits;
	size_t bodies = sort_bytes(p->bodies, p->body_count, sizeof *p->bodies),
	       collidables = sort_bytes(p->collidables, p->collidable_count, sizeof *p->collidables);
	size_t bytes = 1 + (bodies > collidables ? bodies : collidables);
	char* memory = world_scratch(world, bytes);
	if (!memory)
		return no_memory(bytes);
	sort_rows(p->bodies, p->body_count, sizeof *p->bodies, memory);
	for (int k = 0; k < p->body_count; ++k)
		world->host_bodies[p->bodies[k].index].waiting.row = k + 1;
	sort_rows(p->collidables, p->collidable_count, sizeof *p->collidables, memory);
	for (int k = 0; k < p->collidable_count; ++k)
		world->host_collidables[p->collidables[k].index].waiting.row = k + 1;
	return SCREE_OK;
}

// The ends of the runs of neighboring slots that begin at row k.
static int body_run(const Edits* p, int k)
{
	int end = k + 1;
	while (end < p->body_count && p->bodies[end].index == p->bodies[end - 1].index + 1)
		++end;
	return end;
}

// Of a collidable that was destroyed, or whose body is disabled, only the kind is written: its contacts end when they see
// its box become empty.
static bool is_dead(const scree_world* world, int k)
{
	return collidable_kind(world, world->edits.collidables[k].index) == KIND_DEAD;
}

static int collidable_run(const scree_world* world, int k)
{
	const Edits* p = &world->edits;
	int end = k + 1;
	while (end < p->collidable_count && p->collidables[end].index == p->collidables[end - 1].index + 1 &&
	       is_dead(world, end) == is_dead(world, k))
		++end;
	return end;
}

// ---------------------------------------------------------------------------------------------------------------
// long runs, pool by pool
// ---------------------------------------------------------------------------------------------------------------

static const PoolId body_pools[] = {POOL_body,         POOL_pose,       POOL_pose_low, POOL_motion,
                                    POOL_local_center, POOL_color_mask, POOL_guarded,  POOL_kept};

static void body_item(scree_world* world, PoolId pool, const BodyRow* row, void* item)
{
	scree_vec center = pose_point(row->pose, row->center);
	// what is disabled rests, and its velocity is kept beside it
	scree_velocity v = row->velocity, now = row->disabled ? (scree_velocity){0} : v;
	switch (pool)
	{
	case POOL_body:
		*(BodyState*)item = (BodyState){.vx = now.linear.x,
		                                .vy = now.linear.y,
		                                .w = now.angular,
		                                .inv_mass = row->inv_mass,
		                                .inv_inertia = row->inv_inertia};
		break;
	case POOL_pose:
		*(Float4*)item = make_float4(center.x, center.y, row->pose.rotation.c, row->pose.rotation.s);
		break;
	case POOL_motion:
		*(Motion*)item = (Motion){.gravity_scale = row->disabled ? 0.0f : row->gravity_scale,
		                          .linear_damping = row->linear_damping,
		                          .angular_damping = row->angular_damping,
		                          .free_x = row->locks & SCREE_LOCK_X ? 0.0f : 1.0f,
		                          .free_y = row->locks & SCREE_LOCK_Y ? 0.0f : 1.0f};
		break;
	case POOL_local_center:
		*(Float2*)item = make_float2(row->center.x, row->center.y);
		break;
	case POOL_guarded:
		*(Guarded*)item = body_guarded(world, row->index);
		break;
	case POOL_kept:
		*(Float4*)item = make_float4(v.linear.x, v.linear.y, v.angular, 1.0f);
		if (!row->disabled)
			*(Float4*)item = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
		break;
	default:
		*(Word64*)item = 0;
	}
}

// the kind first: it is all that is written of a dead one
static const PoolId collidable_pools[] = {
    POOL_collidable_kind, POOL_collidable_attribute,
    POOL_collidable_body, POOL_collidable_pose,
    POOL_filter,          POOL_box,
    POOL_old_box,         POOL_moved,
    POOL_next_collidable,
};

static Filter filter_item(scree_filter filter)
{
	return (Filter){.category = filter.category, .mask = filter.mask, .group = filter.group};
}

static void collidable_item(const scree_world* world, PoolId pool, int index, void* item)
{
	const HostCollidable* host = world->host_collidables + index;
	switch (pool)
	{
	case POOL_collidable_pose:
		*(Float4*)item = pose_value(host->pose);
		break;
	case POOL_collidable_attribute:
		*(int*)item = host->attribute;
		break;
	case POOL_collidable_body:
		*(int*)item = host->body;
		break;
	case POOL_next_collidable:
		*(int*)item = host->next + 1;
		break;
	case POOL_collidable_kind:
		*(int*)item = collidable_kind(world, index);
		break;
	case POOL_filter:
		*(Filter*)item = filter_item(host->filter);
		break;
	case POOL_box:
	case POOL_old_box:
		*(Float4*)item = make_float4(EMPTY_LOW, EMPTY_LOW, EMPTY_HIGH, EMPTY_HIGH);
		break;
	default:
		*(int*)item = 0;
	}
}

// Is there something to write into the row kept of a body, or to clear?
static bool has_kept(const scree_world* world, const BodyRow* row)
{
	return row->disabled || world->host_bodies[row->index].kept;
}

static bool some_have_kept(const scree_world* world, int begin, int end)
{
	bool some = false;
	for (int k = begin; k < end && !some; ++k)
		some = has_kept(world, world->edits.bodies + k);
	return some;
}

static scree_status write_bodies(scree_world* world, int begin, int end, char* stage)
{
	Backend* b = world->backend;
	const BodyRow* rows = world->edits.bodies;
	for (size_t p = 0; p < sizeof body_pools / sizeof *body_pools; ++p)
	{
		PoolId pool = body_pools[p];
		if (pool == POOL_kept && !some_have_kept(world, begin, end))
			continue;
		for (int k = begin; k < end; ++k)
			body_item(world, pool, rows + k, stage + (size_t)(k - begin) * pool_info[pool].bytes);
		TRY(b->f->write(b, pool, rows[begin].index, end - begin, stage));
	}
	return SCREE_OK;
}

static scree_status write_collidables(scree_world* world, int begin, int end, char* stage)
{
	Backend* b = world->backend;
	const CollidableRow* rows = world->edits.collidables;
	size_t pools = is_dead(world, begin) ? 1 : sizeof collidable_pools / sizeof *collidable_pools;
	for (size_t p = 0; p < pools; ++p)
	{
		PoolId pool = collidable_pools[p];
		for (int k = begin; k < end; ++k)
			collidable_item(world, pool, rows[k].index, stage + (size_t)(k - begin) * pool_info[pool].bytes);
		TRY(b->f->write(b, pool, rows[begin].index, end - begin, stage));
	}
	return SCREE_OK;
}

static scree_status write_attributes(scree_world* world, int first, int count, char* stage)
{
	Backend* b = world->backend;
	for (int k = 0; k < count; ++k)
		attribute_item(world, first + k, (Attribute*)stage + k);
	TRY(b->f->write(b, POOL_attribute, first, count, stage));
	for (int k = 0; k < count; ++k)
		((float*)stage)[k] = attribute_thickness(world, first + k);
	return b->f->write(b, POOL_thickness, first, count, stage);
}

static int compare_slots(const void* a, const void* b) { return *(const int*)a - *(const int*)b; }

// Those that wait, by runs of neighboring slots. One that is gone again is written as it was.
static scree_status write_waiting_attributes(scree_world* world, char* stage)
{
	Edits* p = &world->edits;
	if (p->attribute_count > 1)
		qsort(p->attributes, (size_t)p->attribute_count, sizeof *p->attributes, compare_slots);
	for (int k = 0, end; k < p->attribute_count; k = end)
	{
		for (end = k + 1; end < p->attribute_count && p->attributes[end] == p->attributes[end - 1] + 1;)
			++end;
		TRY(write_attributes(world, p->attributes[k], end - k, stage));
		int rows = p->attributes[end - 1] + 1;
		p->attribute_rows = rows > p->attribute_rows ? rows : p->attribute_rows;
	}
	return SCREE_OK;
}

// ---------------------------------------------------------------------------------------------------------------
// commands
// ---------------------------------------------------------------------------------------------------------------

static int body_commands(scree_world* world, const BodyRow* row, Command* to)
{
	scree_velocity v = row->velocity;
	to[0] = (Command){.kind = COMMAND_BODY, .whole = {has_kept(world, row)}, .value = pose_value(row->pose)};
	to[1] = (Command){.kind = COMMAND_MASS,
	                  .whole = {0, row->disabled},
	                  .value = make_float4(row->inv_mass, row->inv_inertia, row->center.x, row->center.y)};
	to[2] = (Command){.kind = COMMAND_MOTION,
	                  .whole = {(int)row->locks, row->disabled},
	                  .value = make_float4(row->gravity_scale, row->linear_damping, row->angular_damping, 0.0f)};
	to[3] = (Command){.kind = COMMAND_VELOCITY,
	                  .whole = {0, row->disabled},
	                  .value = make_float4(v.linear.x, v.linear.y, v.angular, 0.0f)};
	to[4] = guarded_command(world, row->index);
	for (int k = 0; k < BODY_COMMANDS; ++k)
		to[k].index = row->index;
	return BODY_COMMANDS;
}

static int collidable_commands(const scree_world* world, int k, Command* to)
{
	int index = world->edits.collidables[k].index, count = 0;
	const HostCollidable* host = world->host_collidables + index;
	if (!is_dead(world, k))
	{
		to[count++] = (Command){.kind = COMMAND_COLLIDABLE,
		                        .index = index,
		                        .whole = {host->attribute, host->body},
		                        .value = pose_value(host->pose)};
		to[count++] = (Command){.kind = COMMAND_NEXT, .index = index, .whole = {host->next + 1}};
	}
	Filter filter = filter_item(host->filter);
	to[count] =
	    (Command){.kind = COMMAND_FILTER, .index = index, .whole = {filter.group, collidable_kind(world, index)}};
	Word words[4] = {(Word)filter.category, (Word)(filter.category >> 32), (Word)filter.mask,
	                 (Word)(filter.mask >> 32)};
	memcpy(&to[count].value, words, sizeof words);
	return count + 1;
}

static Waiting* command_waiting(scree_world* world, const Command* c)
{
	if (c->kind >= COMMAND_PLACE)
		return &world->host_collidables[c->index].waiting;
	return &world->host_bodies[c->index].waiting;
}

// Does a command belong to what its slot held before it was made anew?
static bool is_void(scree_world* world, int k)
{
	const Edits* p = &world->edits;
	const Command* c = p->commands + k;
	int row = command_waiting(world, c)->row;
	return row > 0 && k < (c->kind >= COMMAND_PLACE ? p->collidables[row - 1].since : p->bodies[row - 1].since);
}

// Does anything that waits place or make a collidable, so that its box may jump?
static bool places(const Edits* p)
{
	bool found = p->body_count + p->collidable_count > 0;
	for (int k = 0; k < p->command_count && !found; ++k)
		found = p->commands[k].kind == COMMAND_POSE || p->commands[k].kind == COMMAND_PLACE;
	return found;
}

typedef struct // commands by item on their way to the device
{
	Command *from, *grouped; // as they are collected; item by item
	int* begins;             // first command of each group, and the end
	int collected, count, groups;
} Groups;

// A row that stands alone is a group; one with commands behind it is collected with these.
static void add_row(Groups* g, const Waiting* waiting, int count)
{
	if (waiting->group > 0)
	{
		memcpy(g->from + g->collected, g->grouped + g->count, (size_t)count * sizeof *g->from);
		g->collected += count;
		return;
	}
	g->begins[g->groups++] = g->count;
	g->count += count;
}

// The commands of short runs, then the user's. Those of rows without any others, which are most where bodies come and go,
// are groups at once.
static void collect_commands(scree_world* world, Groups* g)
{
	const Edits* p = &world->edits;
	for (int k = 0; k < p->command_count; ++k)
		command_waiting(world, p->commands + k)->group = !is_void(world, k);
	for (int k = 0, end; k < p->body_count; k = end)
	{
		end = body_run(p, k);
		for (int i = k; i < end && end - k < LONG_RUN; ++i)
			add_row(g, &world->host_bodies[p->bodies[i].index].waiting,
			        body_commands(world, p->bodies + i, g->grouped + g->count));
	}
	for (int k = 0, end; k < p->collidable_count; k = end)
	{
		end = collidable_run(world, k);
		for (int i = k; i < end && end - k < LONG_RUN; ++i)
			add_row(g, &world->host_collidables[p->collidables[i].index].waiting,
			        collidable_commands(world, i, g->grouped + g->count));
	}
	for (int k = 0; k < p->command_count; ++k)
	{
		command_waiting(world, p->commands + k)->group = 0;
		if (!is_void(world, k))
			g->from[g->collected++] = p->commands[k];
	}
}

// What was collected by item, each item's in the order of the calls.
static void group_commands(scree_world* world, Groups* g)
{
	int* begins = g->begins + g->groups;
	int groups = 0;
	for (int k = 0; k < g->collected; ++k)
	{
		int* group = &command_waiting(world, g->from + k)->group;
		if (*group == 0)
		{
			*group = ++groups;
			begins[groups] = 0;
		}
		++begins[*group];
	}

	// begins[n + 1] has counted group n; summed up it is the place of the group's next command, and at last its end
	begins[0] = g->count;
	int sum = g->count;
	for (int n = 1; n <= groups; ++n)
	{
		int size = begins[n];
		begins[n] = sum;
		sum += size;
	}
	for (int k = 0; k < g->collected; ++k)
		g->grouped[begins[command_waiting(world, g->from + k)->group]++] = g->from[k];
	for (int k = 0; k < g->collected; ++k)
		command_waiting(world, g->from + k)->group = 0;
	g->groups += groups;
	g->count = sum;
}

// memory has room for most commands, as flush reckons it.
static scree_status send_commands(scree_world* world, int most, char* memory)
{
	Backend* b = world->backend;
	Groups g = {.from = (Command*)memory, .grouped = (Command*)memory + most};
	g.begins = (int*)(g.grouped + most);
	collect_commands(world, &g);
	group_commands(world, &g);
	if (g.count == 0)
		return SCREE_OK;
	TRY(b->f->write(b, POOL_command, 0, g.count, g.grouped));
	TRY(b->f->write(b, POOL_command_group, 0, g.groups + 1, g.begins));
	Step step = {0};
	Run run = {.stage = STAGE_command, .end = g.groups, .count = NO_COUNT, .argument = g.groups};
	return b->f->run(b, &step, &run, 1);
}

// ---------------------------------------------------------------------------------------------------------------
// all of it
// ---------------------------------------------------------------------------------------------------------------

static size_t larger(size_t a, size_t b) { return a > b ? a : b; }

static scree_status flush(scree_world* world)
{
	Edits* p = &world->edits;
	TRY(sort_pending(world));
	int body_rows = 0, collidable_rows = 0, commands = p->command_count;
	for (int k = 0, end; k < p->body_count; k = end)
	{
		end = body_run(p, k);
		if (end - k < LONG_RUN)
			commands += BODY_COMMANDS * (end - k);
		else
			body_rows = end - k > body_rows ? end - k : body_rows;
	}
	for (int k = 0, end; k < p->collidable_count; k = end)
	{
		end = collidable_run(world, k);
		if (end - k < LONG_RUN)
			commands += COLLIDABLE_COMMANDS * (end - k);
		else
			collidable_rows = end - k > collidable_rows ? end - k : collidable_rows;
	}

	// room for everything before anything is sent
	TRY(pipeline_reserve(&world->pipeline, ATTRIBUTE, world->attribute_slots.used));
	TRY(pipeline_reserve(&world->pipeline, BODY, world->bodies.used));
	TRY(pipeline_reserve(&world->pipeline, COLLIDABLE, world->collidables.used));
	TRY(pipeline_reserve(&world->pipeline, COMMAND, commands + 1));
	size_t bytes = (size_t)p->attribute_count * sizeof(Attribute);
	bytes = larger(bytes, (size_t)body_rows * sizeof(BodyState));
	bytes = larger(bytes, (size_t)collidable_rows * sizeof(Filter));
	bytes = larger(bytes, (size_t)commands * (2 * sizeof(Command) + sizeof(int)) + sizeof(int));
	char* memory = world_scratch(world, bytes);
	if (!memory)
		return no_memory(bytes);

	world->pipeline.jumps |= places(p);
	TRY(write_waiting_attributes(world, memory));
	for (int k = 0, end; k < p->body_count; k = end)
	{
		end = body_run(p, k);
		if (end - k >= LONG_RUN)
			TRY(write_bodies(world, k, end, memory));
	}
	for (int k = 0, end; k < p->collidable_count; k = end)
	{
		end = collidable_run(world, k);
		if (end - k >= LONG_RUN)
			TRY(write_collidables(world, k, end, memory));
	}
	TRY(send_commands(world, commands, memory));

	for (int k = 0; k < p->body_count; ++k)
	{
		HostBody* host = world->host_bodies + p->bodies[k].index;
		host->waiting.row = 0;
		host->kept = host->disabled;
	}
	for (int k = 0; k < p->collidable_count; ++k)
		world->host_collidables[p->collidables[k].index].waiting.row = 0;
	for (int k = 0; k < p->attribute_count; ++k)
		world->host_attributes[p->attributes[k]].waiting = false;
	p->body_count = p->collidable_count = p->command_count = p->attribute_count = 0;
	return SCREE_OK;
}

scree_status world_upload(scree_world* world)
{
	const Edits* p = &world->edits;
	if (p->body_count + p->collidable_count + p->command_count + p->attribute_count == 0)
		return SCREE_OK;
	double begin = auto_clock();
	scree_status status = world_note(world, flush(world));
	auto_count(world, begin);
	return status;
}
