// SPDX-License-Identifier: MIT
// read_outputs.c -- reads the outputs of a world alone, and compares the rows of a batch with them.
#include "mirror/mirrored.h"

#define MOST_CONTACTS 128 // maximum number of contacts of a body; the impulses of more are not compared

#define SKIP_SUM (1 << 2) // bit of Read.skipped for the sum of impulses

typedef struct // a channel of a world alone
{
	scree_world* world;
	const scree_channel* channel;
	const scree_counters* counters;
	float* touches; // Mirror.touches
	int skipped;    // bits of the columns that are not compared; a world alone has no such values
} Read;

static void read_nothing(Read* r, float* to)
{
	(void)to;
	r->skipped = ~0;
}

static void read_pose(Read* r, float* to)
{
	scree_pose pose;
	must(scree_body_get_pose(r->world, r->channel->body, &pose));
	to[0] = pose.position.x;
	to[1] = pose.position.y;
	to[2] = pose.rotation.c;
	to[3] = pose.rotation.s;
}

static void read_velocity(Read* r, float* to)
{
	scree_velocity velocity;
	must(scree_body_get_velocity(r->world, r->channel->body, &velocity));
	to[0] = velocity.linear.x;
	to[1] = velocity.linear.y;
	to[2] = velocity.angular;
}

// The pose of `body` in the frame of `other`: A^T (p_b - p_a), A^T B.
static void read_relative_pose(Read* r, float* to)
{
	scree_pose pose, frame;
	must(scree_body_get_pose(r->world, r->channel->body, &pose));
	must(scree_body_get_pose(r->world, r->channel->other, &frame));
	scree_rot a = frame.rotation, b = pose.rotation;
	scree_vec d = {pose.position.x - frame.position.x, pose.position.y - frame.position.y};
	to[0] = a.c * d.x + a.s * d.y;
	to[1] = a.c * d.y - a.s * d.x;
	to[2] = a.c * b.c + a.s * b.s;
	to[3] = a.c * b.s - a.s * b.c;
}

// A contact that rolls over a corner may have one point for scree_contact, and impulses at two in the sum.
static void read_touches(Read* r, float* to)
{
	scree_contact contacts[MOST_CONTACTS];
	int count;
	must(scree_body_get_contacts(r->world, r->channel->body, contacts, MOST_CONTACTS, &count));
	r->skipped = count > MOST_CONTACTS ? SKIP_SUM : 0;
	for (int k = 0; k < count && k < MOST_CONTACTS; ++k)
	{
		r->skipped |= contacts[k].count == 1 ? SKIP_SUM : 0;
		to[2] = to[2] + (contacts[k].points[0].normal_impulse + contacts[k].points[1].normal_impulse);
	}
	to[0] = (float)count;
	to[1] = count > 0 && *r->touches == 0.0f ? 1.0f : 0.0f;
	*r->touches = to[0];
}

static void read_joint_value(Read* r, float* to)
{
	scree_joint_state state;
	must(scree_joint_get_state(r->world, r->channel->joint, &state));
	to[0] = state.values[r->channel->which];
}

static void read_joint_speed(Read* r, float* to)
{
	scree_joint_state state;
	must(scree_joint_get_state(r->world, r->channel->joint, &state));
	to[0] = state.speeds[r->channel->which];
}

static void read_joint_force(Read* r, float* to)
{
	scree_joint_state state;
	must(scree_joint_get_state(r->world, r->channel->joint, &state));
	to[0] = state.force.x;
	to[1] = state.force.y;
	to[2] = state.torque;
}

static void read_rays(Read* r, float* to)
{
	const scree_channel* c = r->channel;
	scree_pose pose = scree_pose_make(0.0f, 0.0f, 0.0f);
	scree_ray ray = {.origin = c->point, .ignored = c->body};
	if (!scree_body_is_null(c->body))
	{
		must(scree_body_get_pose(r->world, c->body, &pose));
		must(scree_body_get_world_point(r->world, c->body, c->point, &ray.origin));
	}
	for (int k = 0; k < c->rays; ++k)
	{
		// the first and the last ray of a whole circle differ
		double steps = c->spread < 6.28f ? c->rays - 1 : c->rays, share = c->rays > 1 ? (double)k / steps - 0.5 : 0.0;
		scree_rot turn = scree_rot_make((float)(share * (double)c->spread)), q = pose.rotation;
		scree_vec in = c->translation, way = {turn.c * in.x - turn.s * in.y, turn.s * in.x + turn.c * in.y};
		scree_query_result found;
		ray.translation = (scree_vec){q.c * way.x - q.s * way.y, q.s * way.x + q.c * way.y};
		bool cast =
		    scree_world_cast_rays(r->world, NULL, &ray, 1, &found) == SCREE_OK; // refused beyond the coordinates
		r->skipped |= cast ? 0 : 1 << k;
		to[k] = cast && found.hit ? found.fraction : 1.0f;
	}
}

static void read_sensor_count(Read* r, float* to)
{
	int count;
	must(scree_collidable_get_visits(r->world, r->channel->collidable, NULL, 0, &count));
	to[0] = (float)count;
}

static void read_overlap(Read* r, float* to) { to[0] = r->counters->penetration; }
static void read_joint_gap(Read* r, float* to) { to[0] = r->counters->joint_gap; }
static void read_not_finite(Read* r, float* to) { to[0] = r->counters->frozen_bodies > 0 ? 1.0f : 0.0f; }

static void (*const reads[])(Read* r, float* to) = {
#define INPUT(kind, object, columns, turn, fill, act)
#define OUTPUT(kind, object, columns, read) [kind] = read,
#include "mirror/channel_kinds.def"
#undef INPUT
#undef OUTPUT
};

// Compares the columns of channel k of a world.
static bool check_channel(Mirror* m, int world, const scree_counters* counters, int k, const float* row)
{
	float alone[FAN_RAYS] = {0.0f};
	const scree_channel* c = m->lists[SCREE_OUTPUTS].channels + k;
	Read read = {m->alone[world], c, counters, m->touches[world] + k, 0};
	if (channel_found(read.world, c)) // else the columns are 0
		reads[c->kind](&read, alone);
	for (int i = 0; i < channel_columns_of(c); ++i)
		if (!(read.skipped >> i & 1) && !same_number(row[i], alone[i]))
			return fault(m, "world %d of template %d has output %d, kind %d, column %d: %.9g, alone %.9g", world,
			             m->template_of[world], k, (int)c->kind, i, (double)row[i], (double)alone[i]);
	return true;
}

bool check_outputs(Mirror* m)
{
	const List* l = m->lists + SCREE_OUTPUTS;
	for (int w = 0; w < m->worlds; ++w)
	{
		const float* row = l->rows + (size_t)w * (size_t)l->columns;
		scree_counters counters;
		must(scree_world_get_counters(m->alone[w], &counters));
		if (m->paused[w])
			continue;
		for (int k = 0; k < l->count; row += channel_columns_of(l->channels + k++))
			if (!check_channel(m, w, &counters, k, row))
				return false;
	}
	return true;
}

void touches_begin(Mirror* m, int world)
{
	const List* l = m->lists + SCREE_OUTPUTS;
	for (int k = 0; k < l->count; ++k)
	{
		int count = 0;
		if (l->channels[k].kind == SCREE_OUTPUT_TOUCH && channel_found(m->alone[world], l->channels + k))
			must(scree_body_get_contacts(m->alone[world], l->channels[k].body, NULL, 0, &count));
		m->touches[world][k] = (float)count;
	}
}
