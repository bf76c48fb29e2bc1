// SPDX-License-Identifier: MIT
// upload_commands.c -- sends short sequences of rows and the user's changes as commands, grouped by item.
#include "world/upload/upload_commands.h"
#include "platform/error.h"
#include "world/objects/collidables.h"
#include "world/objects/mass.h"
#include "world/pool_values.h"
#include "world/upload/edit_order.h"
#include "world/upload/upload_rows.h"
#include <string.h>

static int body_commands(scree_world* world, const BodyRow* row, Command* to)
{
	scree_velocity v = row->velocity;
	int bits = COMMAND_NEW | (row->disabled ? COMMAND_DISABLED : 0);
	to[0] = (Command){.kind = COMMAND_BODY, .value = body_pose(row)};
	memcpy(to[0].whole, &row->center, sizeof row->center);
	to[1] = (Command){.kind = COMMAND_MASS,
	                  .whole = {0, bits},
	                  .value = make_float4(row->inv_mass, row->inv_inertia, row->center.x, row->center.y)};
	to[2] = (Command){.kind = COMMAND_MOTION, .whole = {(int)row->locks, bits}, .value = body_values_row(&row->values)};
	to[3] = (Command){
	    .kind = COMMAND_VELOCITY, .whole = {0, bits}, .value = make_float4(v.linear.x, v.linear.y, v.angular, 0.0f)};
	to[4] = continuous_command(world, row->index);
	to[5] = (Command){.kind = COMMAND_SLEEP,
	                  .whole = {row->asleep ? SLEEP_FROM_START : SLEEP_NOT_YET},
	                  .value = make_float4(row->sleep_threshold, 0.0f, 0.0f, 0.0f)};
	// a cleared row already has the threshold 0, and is awake
	int count = BODY_COMMANDS - !(row->asleep || row->sleep_threshold != 0.0f);
	for (int k = 0; k < count; ++k)
		to[k].index = row->index;
	return count;
}

int collidable_commands(const scree_world* world, int index, Command* to)
{
	int count = 0;
	const HostCollidable* host = world->host_collidables + index;
	if (collidable_kind(world, index) != KIND_DEAD)
	{
		to[count++] = (Command){.kind = COMMAND_COLLIDABLE,
		                        .index = index,
		                        .whole = {host->attribute, host->body},
		                        .value = pose_row(host->pose)};
		to[count++] = (Command){.kind = COMMAND_NEXT, .index = index, .whole = {host->next + 1}};
	}
	Filter filter = filter_row(host->filter, report_bits(host));
	to[count] = (Command){.kind = COMMAND_FILTER,
	                      .index = index,
	                      .whole = {filter.group, device_kind(world, index) | (int)(filter.reports << 8)}};
	Word words[4] = {(Word)filter.category, (Word)(filter.category >> 32), (Word)filter.mask,
	                 (Word)(filter.mask >> 32)};
	memcpy(&to[count].value, words, sizeof words);
	return count + 1;
}

static PendingEdits* command_waiting(scree_world* world, const Command* c)
{
	if (c->kind >= COMMAND_PLACE)
		return &world->host_collidables[c->index].waiting;
	return &world->host_bodies[c->index].waiting;
}

// Returns whether command k belongs to an earlier body or collidable of the same slot, and must not be applied.
static bool is_void(scree_world* world, int k)
{
	const Edits* p = &world->edits;
	const Command* c = p->commands + k;
	int row = command_waiting(world, c)->row;
	return row > 0 && k < (c->kind >= COMMAND_PLACE ? p->collidables[row - 1].since : p->bodies[row - 1].since);
}

typedef struct // commands grouped by item
{
	Command *from, *grouped; // commands as collected; commands ordered by group
	int* begins;             // index in `grouped` of the first command of each group, and the end of the last group
	int collected, count, groups;
} Groups;

// Adds `count` commands of a row, which the caller has written behind the last group. They become a group if the user
// gave no later command for the item. Otherwise they are moved to Groups.from, which group_commands reads.
static void add_row(Groups* g, const PendingEdits* waiting, int count)
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

// Collects the commands of short sequences of rows, then the commands that the user's other changes recorded.
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
			        collidable_commands(world, p->collidables[i].index, g->grouped + g->count));
	}
	for (int k = 0; k < p->command_count; ++k)
	{
		command_waiting(world, p->commands + k)->group = 0;
		if (!is_void(world, k))
			g->from[g->collected++] = p->commands[k];
	}
}

// Groups the collected commands by item; the commands of an item stay in the order of the calls.
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

	// begins[n] is first the size of group n, then the place of its next command, and at last the end of the group
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

scree_status upload_commands(scree_world* world, int most, char* memory)
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
	Run run = {.kernel_id = KERNEL_command, .end = g.groups, .count = NO_COUNT, .argument = g.groups};
	return b->f->run(b, &step, &run, 1);
}
