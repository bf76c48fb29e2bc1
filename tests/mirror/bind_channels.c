// SPDX-License-Identifier: MIT
// bind_channels.c -- binds random channels, of which a batch refuses some.
#include "mirror/mirrored.h"
#include <stdio.h>
#include <string.h>

typedef enum // object that a channel names
{
	WORLD,
	BODY,
	PAIR, // a body and the other one
	RAYS, // a body or none
	COLLIDABLE,
	SENSOR,
	JOINT,
} Named;

typedef struct
{
	const char* name;
	Named named;
	int columns;
} Kind;

static const Kind kinds[] = {
#define INPUT(kind, object, columns, turn, fill, act) [kind] = {#kind, object, columns},
#define OUTPUT(kind, object, columns, read)           [kind] = {#kind, object, columns},
#include "mirror/channel_kinds.def"
#undef INPUT
#undef OUTPUT
};

#define INPUTS (int)SCREE_OUTPUT_POSE
#define KINDS  (int)(sizeof kinds / sizeof *kinds)

int channel_columns_of(const scree_channel* c)
{
	return kinds[c->kind].named == RAYS ? c->rays : kinds[c->kind].columns;
}

bool channel_found(scree_world* world, const scree_channel* c)
{
	bool body = scree_body_is_valid(world, c->body);
	switch (kinds[c->kind].named)
	{
	case WORLD:
		return true;
	case BODY:
		return body;
	case PAIR:
		return body && scree_body_is_valid(world, c->other);
	case RAYS:
		return body || scree_body_is_null(c->body);
	case JOINT:
		return scree_joint_is_valid(world, c->joint);
	default:
		return scree_collidable_is_valid(world, c->collidable);
	}
}

static void aim_rays(Mirror* m, scree_channel* c)
{
	c->point = random_vec(&m->dice, 5.0f);
	c->translation = random_vec(&m->dice, 5.0f);
	c->rays = one_in(&m->dice, 2) ? 1 : 1 + random_below(&m->dice, FAN_RAYS);
	c->spread = rarely(&m->dice, 2, 6.2831855f, random_between(&m->dice, 0.0f, 6.0f));
	if (one_in(&m->dice, 2))
		c->body = SCREE_NULL_BODY;
}

// Names random objects of a template. Returns false if it lacks such objects.
static bool name_objects(Mirror* m, scree_channel* c, const Objects* o)
{
	uint64_t* dice = &m->dice;
	int body = random_below(dice, o->body_count > 0 ? o->body_count : 1);
	int collidable = random_below(dice, o->collidable_count > 0 ? o->collidable_count : 1);
	switch (kinds[c->kind].named)
	{
	case WORLD:
		return true;
	case COLLIDABLE:
	case SENSOR:
		c->collidable = o->collidables[collidable];
		return o->collidable_count > 0 && (kinds[c->kind].named == COLLIDABLE || o->sensors[collidable]);
	case JOINT:
		c->joint = o->joints[random_below(dice, o->joint_count > 0 ? o->joint_count : 1)];
		c->which = (scree_coordinate)random_below(dice, 3);
		return o->joint_count > 0;
	default:
		break;
	}
	c->body = o->bodies[body];
	if (kinds[c->kind].named == PAIR)
		c->other = o->bodies[random_below(dice, o->body_count > 0 ? o->body_count : 1)];
	if (kinds[c->kind].named == RAYS)
		aim_rays(m, c);
	if (c->kind == SCREE_INPUT_THRUST)
		c->point = random_vec(dice, 1.0f);
	return o->body_count > 0;
}

static bool possible(const Mirror* m, scree_channels list, scree_channel_kind kind)
{
	if (kind == SCREE_INPUT_TARGET && list == SCREE_RESET_INPUTS)
		return false;
	return kind != SCREE_INPUT_GRAVITY || !m->varied; // which gravity a reset leaves depends on the calls before
}

// Binds up to eight channels that the batch accepts, or none.
static bool bind(Mirror* m, scree_channels list)
{
	List* l = m->lists + list;
	scree_channel channels[MOST_CHANNELS];
	char text[1000] = "";
	int count = 0, columns = 0, want = one_in(&m->dice, 4) ? 0 : 1 + random_below(&m->dice, 8);
	for (int tries = 0; count < want && tries < 40; ++tries)
	{
		const Objects* o = &m->templates[random_below(&m->dice, m->template_count)].objects;
		int kind =
		    list == SCREE_OUTPUTS ? INPUTS + random_below(&m->dice, KINDS - INPUTS) : random_below(&m->dice, INPUTS);
		channels[count] = scree_channel_make((scree_channel_kind)kind);
		if (!possible(m, list, (scree_channel_kind)kind) || !name_objects(m, channels + count, o))
			continue;
		scree_status status = scree_batch_bind(m->batch, list, channels, count + 1, NULL);
		count += status == SCREE_OK;
		if (status != SCREE_OK && status != SCREE_ERROR_INVALID)
			return needed(m, status, "scree_batch_bind");
	}
	for (int k = 0; k < count; ++k)
	{
		const scree_channel* c = channels + k;
		size_t length = strlen(text);
		columns += channel_columns_of(c);
		snprintf(text + length, sizeof text - length, " %s body %u, collidable %u, joint %u.%d;", kinds[c->kind].name,
		         (unsigned)c->body.index, (unsigned)c->collidable.index, (unsigned)c->joint.index, (int)c->which);
	}
	note(m, "bind list %d:%s", (int)list, text);
	NEED(m, scree_batch_bind(m->batch, list, channels, count, NULL));
	*l = (List){.count = count, .columns = columns, .rows = scree_batch_get_rows(m->batch, list)};
	memcpy(l->channels, channels, sizeof *channels * (size_t)count);
	for (int k = 0; k < m->worlds && list == SCREE_OUTPUTS; ++k)
		touches_begin(m, k);
	if (columns != scree_batch_get_columns(m->batch, list))
		return fault(m, "the list has %d columns, must have %d", scree_batch_get_columns(m->batch, list), columns);
	return true;
}

bool bind_inputs(Mirror* m) { return bind(m, SCREE_STEP_INPUTS); }

bool bind_resets(Mirror* m) { return bind(m, SCREE_RESET_INPUTS); }

bool bind_outputs(Mirror* m) { return bind(m, SCREE_OUTPUTS); }
