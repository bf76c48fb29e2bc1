// SPDX-License-Identifier: MIT
// channel_set.c -- sorts the channels of a list into groups, and finds their objects in each template.
#include "batch/channel_set.h"
#include "batch/channel_objects.h"
#include "world/units/scale.h"
#include <stdlib.h>

typedef enum // kinds of groups, in their order; a kernel processes each
{
	OF_BODIES, // channels of a body, a collidable or the world
	OF_TOUCHES,
	OF_JOINTS,
	OF_RAYS
} PartClass;

typedef struct // a part of a channel of the user: the whole channel, or one ray of a fan
{
	int from;   // number of the channel
	int ray;    // number of the ray
	int column; // first column
	PartClass class;
	uint64_t object; // generation and index of the object
} Part;

static int compare_parts(const void* x, const void* y)
{
	const Part *a = x, *b = y;
	if (a->class != b->class)
		return (int)a->class - (int)b->class;
	if (a->object != b->object)
		return a->object < b->object ? -1 : 1;
	return a->from != b->from ? a->from - b->from : a->ray - b->ray;
}

// Objects of several templates may have the same index and other generations; each is a group of its own.
static uint64_t handle_bits(uint32_t index, uint32_t generation) { return (uint64_t)generation << 32 | index; }

// Returns the number of parts that kernels process. Parameters are applied by the host.
static int parts_of(const scree_channel* c) { return channel_is_parameter((int)c->kind) ? 0 : channel_parts(c); }

static PartClass class_of(scree_channel_kind kind)
{
	if (kind == SCREE_OUTPUT_RAYS || kind == SCREE_OUTPUT_TOUCH)
		return kind == SCREE_OUTPUT_RAYS ? OF_RAYS : OF_TOUCHES;
	return channel_of_joint(kind) ? OF_JOINTS : OF_BODIES;
}

// Lists the parts in the order of groups. Touches and rays are groups of their own, because each takes long.
static void list_parts(Part* parts, const scree_channel* channels, int count)
{
	int n = 0, column = 0;
	for (int k = 0; k < count; ++k)
	{
		const scree_channel* c = channels + k;
		for (int r = 0; r < parts_of(c); ++r, ++n)
		{
			parts[n] = (Part){.from = k, .ray = r, .column = column + r, .class = class_of(c->kind)};
			parts[n].object = parts[n].class == OF_JOINTS ? handle_bits(c->joint.index, c->joint.generation)
			                                              : handle_bits(c->body.index, c->body.generation);
			if (parts[n].class == OF_RAYS || parts[n].class == OF_TOUCHES)
				parts[n].object = (uint64_t)n;
		}
		column += channel_columns(c);
	}
	qsort(parts, (size_t)n, sizeof *parts, compare_parts);
}

static void find_groups(ChannelSet* set, const Part* parts, int count)
{
	set->groups = set->touch_group = set->joint_group = set->ray_group = 0;
	for (int n = 0; n < count; ++n)
	{
		if (n > 0 && parts[n].class == parts[n - 1].class && parts[n].object == parts[n - 1].object)
			continue;
		set->group[set->groups++] = n;
		set->touch_group += parts[n].class < OF_TOUCHES;
		set->joint_group += parts[n].class < OF_JOINTS;
		set->ray_group += parts[n].class < OF_RAYS;
	}
	set->group[set->groups] = count;
}

static void note_kind(ChannelSet* set, scree_channel_kind kind)
{
	set->aims |= kind == SCREE_INPUT_TARGET;
	set->acts |= kind == SCREE_INPUT_FORCE || kind == SCREE_INPUT_THRUST || kind == SCREE_INPUT_TORQUE;
	set->poses |= kind == SCREE_INPUT_POSE || kind == SCREE_INPUT_TARGET;
	set->parameters += channel_is_parameter((int)kind);
	set->masses |= kind == SCREE_INPUT_MASS;
	set->pulls |= kind == SCREE_INPUT_GRAVITY;
	set->owns |= channel_is_parameter((int)kind) && kind != SCREE_INPUT_GRAVITY;
}

static scree_status allocate(ChannelSet* set, const char* function, int parts, int templates)
{
	set->channels = scree_allocate(sizeof *set->channels * (size_t)(parts * templates + 1));
	set->group = scree_allocate(sizeof *set->group * (size_t)(parts + 1));
	set->parameter = scree_allocate(sizeof *set->parameter * (size_t)(set->parameters * templates + 1));
	set->rules = scree_allocate(sizeof *set->rules * (size_t)(set->columns + 1));
	set->least = scree_allocate(sizeof(float) * (size_t)(2 * BOUND_ROWS * set->columns + 1));
	set->most = set->least + BOUND_ROWS * set->columns;
	if (!set->channels || !set->group || !set->parameter || !set->rules || !set->least)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d channels", function, parts);
	return SCREE_OK;
}

// Fails if a joint has a length where that of another template has an angle, and lengths are converted.
static scree_status check_power(const ChannelSet* set, ChannelPlace at, const scree_channel* c,
                                const scree_world* world, int column)
{
	ColumnRule rules[4]; // those of a joint
	if (set->unit == 0.0 || !channel_of_joint(c->kind))
		return SCREE_OK;
	channel_rules(rules, c, world);
	if (rules[0].power == set->rules[column].power)
		return SCREE_OK;
	return fail(
	    SCREE_ERROR_INVALID,
	    "%s: channels[%d] has a joint of another type in template %d than before, and scree_world_def.length_unit "
	    "is %s",
	    at.function, at.channel, at.number, decimal((float)set->unit).text);
}

// Leaves out targets of a template's bodies that a later velocity of the list cancels, or a later target replaces.
static void cancel_targets(Channel* made, int count)
{
	for (int n = 0; n < count; ++n)
		for (int later = n + 1; later < count && made[n].kind == CHANNEL_SET_TARGET; ++later)
			if ((made[later].kind == CHANNEL_SET_VELOCITY || made[later].kind == CHANNEL_SET_TARGET) &&
			    made[later].item == made[n].item)
				made[n].kind = CHANNEL_KINDS;
}

static scree_status find_objects(ChannelSet* set, const char* function, const Part* parts, int count,
                                 const scree_channel* channels, const Template* templates, int template_count)
{
	for (int n = 0; n < count; ++n)
	{
		bool found = false;
		for (int t = 0; t < template_count; ++t)
		{
			Channel* made = set->channels + t * count + n;
			ChannelPlace at = {function, parts[n].from, t};
			TRY(channel_find(made, at, channels + parts[n].from, parts[n].ray, templates[t].world));
			made->column = parts[n].column;
			if (found && made->kind != CHANNEL_KINDS)
				TRY(check_power(set, at, channels + parts[n].from, templates[t].world, parts[n].column));
			found |= made->kind != CHANNEL_KINDS;
			if (made->kind != CHANNEL_KINDS && parts[n].ray == 0)
				channel_rules(set->rules + parts[n].column, channels + parts[n].from, templates[t].world);
		}
		if (!found)
			return fail(SCREE_ERROR_STALE, "%s: channels[%d] has an object that no template has", function,
			            parts[n].from);
	}
	for (int t = 0; t < template_count && set->aims; ++t)
		cancel_targets(set->channels + t * count, count);
	return SCREE_OK;
}

// Fails if two parameters set the same value of a template: calls for a world alone would make both changes.
static scree_status check_repeats(const ChannelSet* set, const char* function, int number)
{
	const Channel* found = set->parameter + number * set->parameters;
	for (int k = 0; k < set->parameters; ++k)
		for (int other = 0; other < k; ++other)
			if (found[k].kind != CHANNEL_KINDS && found[k].kind == found[other].kind &&
			    found[k].item == found[other].item)
				return fail(SCREE_ERROR_INVALID, "%s: columns %d and %d set the same value of a world (template %d)",
				            function, found[other].column, found[k].column, number);
	return SCREE_OK;
}

// Finds the objects of the parameters. Fails if no template has the object of one.
static scree_status find_parameters(ChannelSet* set, const char* function, const scree_channel* channels, int count,
                                    const Template* templates, int template_count)
{
	for (int k = 0, n = 0, column = 0; k < count; column += channel_columns(channels + k++))
	{
		bool found = false;
		if (!channel_is_parameter((int)channels[k].kind))
			continue;
		for (int t = 0; t < template_count; ++t)
		{
			Channel* made = set->parameter + t * set->parameters + n;
			TRY(channel_find(made, (ChannelPlace){function, k, t}, channels + k, 0, templates[t].world));
			made->column = column;
			found |= made->kind != CHANNEL_KINDS;
			if (made->kind != CHANNEL_KINDS)
				channel_rules(set->rules + column, channels + k, templates[t].world);
		}
		if (!found)
			return fail(SCREE_ERROR_STALE, "%s: channels[%d] has an object that no template has", function, k);
		++n;
	}
	for (int t = 0; t < template_count; ++t)
		TRY(check_repeats(set, function, t));
	return SCREE_OK;
}

// Sets the bounds of BOUND_ROWS rows.
static void repeat_bounds(ChannelSet* set)
{
	for (int k = 0; k < BOUND_ROWS * set->columns; ++k)
	{
		set->least[k] = set->rules[k % set->columns].least;
		set->most[k] = set->rules[k % set->columns].most;
		set->parts |= set->rules[k % set->columns].part > PART_POSE;
	}
}

scree_status channels_open(ChannelSet* set, const char* function, bool inputs, const scree_channel* channels, int count,
                           const Template* templates, int template_count)
{
	int parts_count = 0;
	*set = (ChannelSet){.unit = (double)templates[0].world->def.length_unit};
	for (int k = 0; k < count; ++k)
	{
		TRY(channel_check((ChannelPlace){function, k, 0}, channels + k, inputs));
		note_kind(set, channels[k].kind);
		set->columns += channel_columns(channels + k);
		parts_count += parts_of(channels + k);
		if (set->columns > MOST_COLUMNS)
			return fail(SCREE_ERROR_INVALID, "%s: channels have more than %d columns", function, MOST_COLUMNS);
	}
	for (int t = 1; t < template_count; ++t)
		if (count > 0 && templates[t].world->def.length_unit != templates[0].world->def.length_unit)
			return fail(SCREE_ERROR_INVALID, "%s: template %d has another unit of length than template 0", function, t);
	TRY(allocate(set, function, parts_count, template_count));
	Part* parts = scree_allocate(sizeof *parts * (size_t)(parts_count + 1));
	if (!parts)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d channels", function, parts_count);
	list_parts(parts, channels, count);
	find_groups(set, parts, parts_count);
	set->count = parts_count;
	scree_status status = find_objects(set, function, parts, parts_count, channels, templates, template_count);
	scree_release(parts);
	if (status == SCREE_OK)
		status = find_parameters(set, function, channels, count, templates, template_count);
	repeat_bounds(set);
	return status;
}

void channels_close(ChannelSet* set)
{
	scree_release(set->channels);
	scree_release(set->group);
	scree_release(set->parameter);
	scree_release(set->rules);
	scree_release(set->least);
	*set = (ChannelSet){.count = 0};
}
