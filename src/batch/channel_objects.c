// SPDX-License-Identifier: MIT
// channel_objects.c -- checks a channel, finds its object in a template, and returns the rules of its columns.
#include "batch/channel_objects.h"
#include "world/edits.h"
#include "world/objects/handles.h"
#include "world/objects/joint_check.h"
#include "world/objects/mass.h"
#include "world/pool_values.h"
#include "world/units/scale.h"
#include "world/world.h"

enum
{
	OF_BODY,
	OF_COLLIDABLE,
	OF_JOINT,
	OF_WORLD,
};

typedef struct
{
	int8_t columns, of;
	bool input;
} KindRow;

static const KindRow kinds[CHANNEL_KINDS] = {
#define INPUT(name, columns, of)  [CHANNEL_SET_##name] = {columns, OF_##of, true},
#define OUTPUT(name, columns, of) [CHANNEL_GET_##name] = {columns, OF_##of, false},
#include "pools/channel_kinds.def"
#undef INPUT
#undef OUTPUT
};

#define INPUT(name, columns, of) \
	_Static_assert((int)SCREE_INPUT_##name == (int)CHANNEL_SET_##name, "kinds of channels");
#define OUTPUT(name, columns, of) \
	_Static_assert((int)SCREE_OUTPUT_##name == (int)CHANNEL_GET_##name, "kinds of channels");
#include "pools/channel_kinds.def"
#undef INPUT
#undef OUTPUT

int channel_parts(const scree_channel* c) { return c->kind == SCREE_OUTPUT_RAYS ? c->rays : 1; }
int channel_columns(const scree_channel* c) { return kinds[c->kind].columns * channel_parts(c); }
bool channel_of_joint(scree_channel_kind kind) { return kinds[kind].of == OF_JOINT; }
bool channel_is_parameter(int kind) { return kind >= CHANNEL_SET_GRAVITY && kind <= CHANNEL_SET_JOINT_ENABLED; }

static scree_status refuse_channel(ChannelPlace at, const char* text)
{
	return fail(SCREE_ERROR_INVALID, "%s: channels[%d] %s (template %d)", at.function, at.channel, text, at.number);
}

// Fails if a channel of a value of the world names an object.
static scree_status check_no_object(ArgumentPlace place, const scree_channel* c)
{
	const struct
	{
		const char* member;
		uint32_t index;
	} objects[] = {{".body", c->body.index},
	               {".other", c->other.index},
	               {".collidable", c->collidable.index},
	               {".other_collidable", c->other_collidable.index},
	               {".joint", c->joint.index}};
	for (size_t k = 0; k < sizeof objects / sizeof *objects; ++k)
		if (objects[k].index != 0)
			return refuse(SCREE_ERROR_INVALID, place, objects[k].member,
			              "(index %u) must be null, because the channel is a value of the world", objects[k].index);
	return SCREE_OK;
}

scree_status channel_check(ChannelPlace at, const scree_channel* c, bool inputs)
{
	ArgumentPlace place = {at.function, "channels", at.channel};
	if ((int)c->kind < 0 || (int)c->kind >= CHANNEL_KINDS)
		return refuse(SCREE_ERROR_INVALID, place, ".kind", "is %d, not a kind of channel", (int)c->kind);
	if (kinds[c->kind].input != inputs)
		return refuse(SCREE_ERROR_INVALID, place, ".kind", inputs ? "is an output" : "is an input");
	if (kinds[c->kind].of == OF_JOINT && c->kind != SCREE_OUTPUT_JOINT_FORCE &&
	    ((int)c->which < 0 || (int)c->which > SCREE_ANGLE))
		return refuse(SCREE_ERROR_INVALID, place, ".which", "is %d, not a coordinate", (int)c->which);
	if (kinds[c->kind].of == OF_WORLD)
		TRY(check_no_object(place, c));
	TRY(check_vec(place, ".point", c->point, SCREE_MAX_COORDINATE));
	if (c->kind != SCREE_OUTPUT_RAYS)
		return SCREE_OK;
	TRY(check_vec(place, ".translation", c->translation, SCREE_MAX_COORDINATE));
	TRY(check_real(place, ".spread", c->spread, 0.0f, 6.2831855f));
	if (c->rays < 1 || c->rays > MOST_RAYS)
		return refuse(SCREE_ERROR_INVALID, place, ".rays", "is %d, must be from 1 to %d", c->rays, MOST_RAYS);
	return SCREE_OK;
}

static scree_status check_body_kind(ChannelPlace at, scree_channel_kind kind, const HostBody* host)
{
	scree_body_type type = host->type;
	if (kind < SCREE_INPUT_VELOCITY && type != SCREE_BODY_DYNAMIC)
		return refuse_channel(at, "pushes a body that is not dynamic");
	if (kind == SCREE_INPUT_ENABLED && host->fields > 0)
		return refuse_channel(at, "enables a body that carries fields");
	if (kind == SCREE_INPUT_MASS && type != SCREE_BODY_DYNAMIC)
		return refuse_channel(at, "sets the mass of a body that is not dynamic");
	if (kind == SCREE_INPUT_VELOCITY && type == SCREE_BODY_STATIC)
		return refuse_channel(at, "sets the velocity of a static body");
	if (kind == SCREE_INPUT_TARGET && type != SCREE_BODY_KINEMATIC)
		return refuse_channel(at, "is the target of a body that is not kinematic");
	return SCREE_OK;
}

// Checks that the body is one whose rest is measured.
static scree_status check_rest(ChannelPlace at, const scree_world* world, int body)
{
	if (world->host_bodies[body].type != SCREE_BODY_DYNAMIC)
		return refuse_channel(at, "is the rest of a body that is not dynamic");
	return world->def.sleep ? SCREE_OK : refuse_channel(at, "is the rest of a body in a world that does not sleep");
}

// Sets start and path of ray number `ray`: the fan is centered on the translation, and goes counter-clockwise.
static void place_ray(Channel* made, const scree_channel* c, int ray)
{
	scree_vec path = c->translation;
	if (c->rays > 1)
	{
		double share = (double)ray / (c->spread < 6.28f ? c->rays - 1 : c->rays) - 0.5;
		scree_rot turn = scree_rot_make((float)(share * (double)c->spread));
		path = (scree_vec){turn.c * path.x - turn.s * path.y, turn.s * path.x + turn.c * path.y};
	}
	made->place = make_float4(c->point.x, c->point.y, path.x, path.y);
}

static scree_status find_body(Channel* made, ChannelPlace at, const scree_channel* c, int ray, const scree_world* world)
{
	bool fixed = c->kind == SCREE_OUTPUT_RAYS && scree_body_is_null(c->body); // rays of the world
	if (!fixed && !body_is_valid(world, c->body))
		return SCREE_OK;
	if (c->kind == SCREE_OUTPUT_RELATIVE_POSE && !body_is_valid(world, c->other))
		return SCREE_OK;
	made->item = fixed ? 0 : (int)c->body.index;
	made->other = (int)c->other.index;
	made->locks = fixed ? 0 : (int)world->host_bodies[made->item].locks;
	made->bits = fixed ? 0 : command_bits(world, made->item) & COMMAND_JOINED;
	made->place = make_float4(c->point.x, c->point.y, 0.0f, 0.0f);
	if (c->kind == SCREE_OUTPUT_RAYS)
		place_ray(made, c, ray);
	if (world->def.length_unit != 0.0f)
		units_scale((double)world->def.length_unit, (char*)&made->place, 4, 1, TO_METRES);
	made->kind = (int)c->kind;
	if (c->kind == SCREE_OUTPUT_REST)
		return check_rest(at, world, made->item);
	return kinds[c->kind].input ? check_body_kind(at, c->kind, world->host_bodies + made->item) : SCREE_OK;
}

// Finds a collidable, or if it is null a body. Sets the index and returns true if the template has it, or both are null.
static bool find_toucher(const scree_world* world, scree_collidable collidable, scree_body body, int bit, int* item,
                         int* which)
{
	if (!scree_collidable_is_null(collidable))
	{
		*item = (int)collidable.index - 1;
		return collidable_is_valid(world, collidable);
	}
	*item = scree_body_is_null(body) ? -1 : (int)body.index;
	*which |= bit;
	return *item < 0 || body_is_valid(world, body);
}

static scree_status find_touch(Channel* made, ChannelPlace at, const scree_channel* c, const scree_world* world)
{
	int item, other, which = 0;
	bool found = find_toucher(world, c->collidable, c->body, TOUCH_BODY, &item, &which);
	found &= find_toucher(world, c->other_collidable, c->other, TOUCH_OTHER_BODY, &other, &which);
	if (item < 0)
		return refuse_channel(at, "has neither a collidable nor a body");
	if (!found)
		return SCREE_OK;
	*made = (Channel){.kind = (int)c->kind, .item = item, .other = other, .which = which};
	return SCREE_OK;
}

static scree_status find_collidable(Channel* made, ChannelPlace at, const scree_channel* c, const scree_world* world)
{
	if (scree_collidable_is_null(c->collidable))
		return refuse_channel(at, "has no collidable");
	if (!collidable_is_valid(world, c->collidable))
		return SCREE_OK;
	made->item = (int)c->collidable.index - 1;
	if (c->kind == SCREE_OUTPUT_SENSOR_COUNT && !world->host_collidables[made->item].sensor)
		return refuse_channel(at, "counts the visitors of a collidable that is no sensor");
	made->kind = (int)c->kind;
	return SCREE_OK;
}

// Sets the range of the target of a joint: on an open path, a lock holds the joint within the length of the path.
static void bound_target(Channel* made, const scree_world* world, const HostJoint* host,
                         const scree_joint_coordinate* coordinate)
{
	made->lower = -FLT_MAX;
	made->upper = FLT_MAX;
	if (host->path < 0 || made->which != SCREE_ALONG || !coordinate->locked)
		return;
	const HostPath* path = world->host_paths + host->path;
	if (path->samples[path->segments].length != 0.0f)
		return;
	made->lower = 0.0f;
	made->upper = path->samples[path->segments].along;
}

static scree_status find_joint(Channel* made, ChannelPlace at, const scree_channel* c, const scree_world* world)
{
	if (!joint_is_valid(world, c->joint))
		return SCREE_OK;
	made->kind = (int)c->kind;
	made->item = (int)c->joint.index - 1;
	made->which = (int)c->which;
	const HostJoint* host = world->host_joints + made->item;
	if (!kinds[c->kind].input || c->kind == SCREE_INPUT_JOINT_ENABLED)
		return SCREE_OK;
	const scree_joint_coordinate* coordinate = host->def.coordinates + c->which;
	bool motor = c->kind == SCREE_INPUT_MOTOR_SPEED || c->kind == SCREE_INPUT_MOTOR_MAX;
	if (motor && (!coordinate->motor || coordinate->locked))
		return refuse_channel(at, "drives a coordinate of a joint without a motor, or with a lock");
	if (!motor && !coordinate->locked && !coordinate->spring)
		return refuse_channel(at, "is the target of a coordinate of a joint without lock and spring");
	bound_target(made, world, host, coordinate);
	return SCREE_OK;
}

scree_status channel_find(Channel* made, ChannelPlace at, const scree_channel* c, int ray, const scree_world* world)
{
	*made = (Channel){.kind = CHANNEL_KINDS, .other = -1};
	if (kinds[c->kind].of == OF_WORLD)
		made->kind = (int)c->kind;
	else if (kinds[c->kind].of == OF_JOINT)
		TRY(find_joint(made, at, c, world));
	else if (c->kind == SCREE_OUTPUT_SENSOR_COUNT || c->kind == SCREE_INPUT_SURFACE)
		TRY(find_collidable(made, at, c, world));
	else if (kinds[c->kind].of == OF_COLLIDABLE)
		TRY(find_touch(made, at, c, world));
	else
		TRY(find_body(made, at, c, ray, world));
	made->missing = c->kind == SCREE_OUTPUT_RAYS ? 1 : channel_columns(c);
	made->category = c->category;
	made->mask = c->mask;
	return SCREE_OK;
}

// Returns the power of length of column k of a channel.
static int column_power(const scree_channel* c, int k, const scree_world* world)
{
	const scree_joint_def* joint = channel_of_joint(c->kind) ? &world->host_joints[c->joint.index - 1].def : NULL;
	UnitContext context = {.joint = joint, .which = (int)c->which};
	switch (c->kind)
	{
	case SCREE_INPUT_FORCE:
	case SCREE_INPUT_THRUST:
	case SCREE_INPUT_IMPULSE:
		return 1;
	case SCREE_INPUT_TORQUE:
	case SCREE_INPUT_ANGULAR_IMPULSE:
		return 2;
	case SCREE_INPUT_MOTOR_MAX:
		return units_power(FORCE + (int)c->which, &context, NULL);
	case SCREE_INPUT_MOTOR_SPEED:
	case SCREE_INPUT_JOINT_TARGET:
		return units_power(COORDINATE + (int)c->which, &context, NULL);
	case SCREE_OUTPUT_JOINT_VALUE:
	case SCREE_OUTPUT_JOINT_SPEED:
		return units_power(MEASURED + (int)c->which, &context, NULL);
	case SCREE_OUTPUT_JOINT_FORCE:
		return k < 2 ? 1 : 2;
	case SCREE_OUTPUT_TOUCH:
		return k == 2 ? 1 : 0;
	case SCREE_OUTPUT_RAYS:
	case SCREE_INPUT_ENABLED:
	case SCREE_INPUT_JOINT_ENABLED:
	case SCREE_OUTPUT_REST:
	case SCREE_OUTPUT_SENSOR_COUNT:
	case SCREE_OUTPUT_NOT_FINITE:
		return 0;
	case SCREE_INPUT_GRAVITY:
		return 1;
	case SCREE_INPUT_MASS:
		return k == 0 ? 0 : k == 1 ? 2 : 1;
	case SCREE_INPUT_SURFACE:
		return k == 3 ? 1 : 0;
	default: // poses, velocities and lengths
		return k < 2 ? 1 : 0;
	}
}

// Sets the range of column k of a parameter.
static void parameter_range(ColumnRule* rule, scree_channel_kind kind, int k)
{
	rule->least = -FLT_MAX;
	rule->most = FLT_MAX;
	if (kind == SCREE_INPUT_MASS)
	{
		rule->least = k == 0 ? LEAST_MASS : k == 1 ? 0.0f : -SCREE_MAX_COORDINATE;
		rule->most = k < 2 ? HEAVY_MASS : SCREE_MAX_COORDINATE; // a heavier body would change bits of all worlds
		rule->part = k == 1 ? PART_INERTIA : -1;
	}
	if (kind == SCREE_INPUT_SURFACE)
	{
		rule->least = k < 3 ? 0.0f : -SCREE_MAX_COORDINATE;
		rule->most = k == 1 ? MOST_RESTITUTION : k == 3 ? SCREE_MAX_COORDINATE : MOST_SURFACE;
	}
	if (kind == SCREE_INPUT_ENABLED || kind == SCREE_INPUT_JOINT_ENABLED)
	{
		rule->least = 0.0f;
		rule->most = 1.0f;
		rule->part = PART_SWITCH;
	}
}

void channel_rules(ColumnRule* rules, const scree_channel* c, const scree_world* world)
{
	bool any = c->kind <= SCREE_INPUT_ANGULAR_IMPULSE || c->kind == SCREE_INPUT_MOTOR_MAX;
	float most = any ? FLT_MAX : SCREE_MAX_COORDINATE;
	for (int k = 0; k < channel_columns(c); ++k)
	{
		bool pose = c->kind == SCREE_INPUT_POSE || c->kind == SCREE_INPUT_TARGET;
		rules[k] = (ColumnRule){.least = c->kind == SCREE_INPUT_MOTOR_MAX ? 0.0f : -most,
		                        .most = most,
		                        .power = (int8_t)column_power(c, k, world),
		                        .part = pose && k == 0 ? PART_POSE : -1};
		if (channel_is_parameter((int)c->kind))
			parameter_range(rules + k, c->kind, k);
	}
}
