// SPDX-License-Identifier: MIT
// transform.h -- computes world poses and tight boxes of collidables; replaces enlarged boxes that tight boxes exceed.
#ifndef TRANSFORM_H
#define TRANSFORM_H
#include "constraints/constraint_kinds.h"
#include "dialect/vec.h"
#include "pools/bays.h"
#include "stages/broad_phase/transform_grain.h"
#include "stages/edit/active.h"
#include "stages/edit/asleep.h"
#include "stages/geometry/box.h"
#include "stages/geometry/sweep.h"

// Keeps the counters that the start of a step clears, for an abandoned step, or restores them.
INLINE void counters_keep(const Pools* p)
{
	GLOBAL Counters* c = p->counters;
	int k = 0;
#define KEEP(member) c->cleared[k++] = c->member;
	CLEARED_COUNTERS(KEEP)
#undef KEEP
}

INLINE void counters_restore(const Pools* p)
{
	GLOBAL Counters* c = p->counters;
	int k = 0;
#define RESTORE(member) c->member = c->cleared[k++];
	CLEARED_COUNTERS(RESTORE)
#undef RESTORE
}

KERNEL(step_begin)
{
	GLOBAL Counters* c = p->counters;
	counters_keep(p);
	c->alive = c->alive - c->released;
	c->updated_boxes = 0;
	c->refit = 0;
	if (BATCHED(p))
	{
		c->refit = c->boxes_copied;
		c->boxes_copied = 0;
	}
	for (int level = 0; level < MAX_LEVELS; ++level)
		c->stale_nodes[level] = 0;
	c->jumped = 0;
	c->order[0] = 0;
	c->order[1] = 0;
	c->changed = 0;
	c->shifted = 0;
	c->kept = 0x7fffffff;
	c->sort_pairs = 0;
	c->search = 0;
	c->live = c->contacts;
	c->look = 0;
	c->arranged = 0;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
	{
		c->dirty[kind] = c->stale_layout[kind] || (kind == CONSTRAINT_CONTACT && c->belts && layout_has_spokes(c));
		c->changed |= c->dirty[kind];
		c->arrange[kind] = 0;
	}
	c->traversals = 0;
	c->rest = 0;
	c->pairs = 0;
	c->over_limit = 0;
	c->created = 0;
	c->stalled = 0;
	c->needed = 0;
	c->released = 0;
	c->began = 0;
	c->ended = 0;
	c->gathered = c->belts ? c->contacts : 0;
	c->belts = 0;
	c->entered = 0;
	c->rule_changes = 0;
	c->continuous_items = 0;
	c->listed_bodies = 0;
	if (p->step.dt > 0.0f)
	{
		c->presses = !BATCHED(p) && ((c->press[0] && c->press[1]) || c->ways) ? 0x7fffffff : 0;
		c->press[0] = 0;
		c->press[1] = 0;
		c->ways = 0;
	}
	c->joined_dirty = c->joints_dirty;
	if (BATCHED(p) && c->joints_copied)
	{
		c->joints_dirty = 0x7fffffff;
		c->joints_copied = 0;
	}
	c->penetration = 0;
	c->joint_gap = 0;
	c->joint_events = 0;
	c->touches_began = 0;
	c->waiting = 0;
	c->refused = 0;
	c->asked = 0;
	c->holds = 0;
	c->touches_ended = 0;
	c->hits = 0;
	for (int k = 0; k <= MAX_ROUNDS; ++k)
		c->uncolored[k] = 0;
	(void)i;
}

#ifndef SCREE_NO_BATCHES
// Item: a live bay, before the solve. Does the same for the values of each world, unless the step is repeated or
// abandoned.
KERNEL(bay_begin)
{
	GLOBAL BayState* state = p->bay_state + i;
	if (p->counters->stalled)
		return;
	state->penetration = state->joint_gap = state->nonfinite = state->crowded = state->joints_dirty = 0;
	state->surfaces_used = state->surfaces;
	state->surfaces = 0;
	if (!(p->step.dt > 0.0f))
		return;
	state->presses = (state->press[0] && state->press[1]) || state->ways;
	state->press[0] = state->press[1] = state->ways = 0;
	if (state->presses)
		raise_int(&p->counters->presses, 0x7fffffff);
	state->taut_used = state->taut_seen;
	state->taut_seen = state->taut;
	if (state->taut)
		raise_int(&p->counters->taut, 1);
	if (state->taut_used)
		state->taut = 0; // the warm starts of this step set it again
	bay_set_ratio(p, state);
	state->substep = p->step.h;
}
#endif

// Returns the world pose of collidable i, with bodies at the given poses. The pose of a collidable without a body is
// already in the world.
INLINE WorldShape collidable_at(const Pools* p, int i, const GLOBAL Float4* poses)
{
	WorldShape world_shape;
	Float4 own = p->collidable_pose[i];
	int body = p->collidable_body[i];
	world_shape.attribute = p->collidable_attribute[i];
	world_shape.body = body;
	Vec position = vec(own.x, own.y), rotation = vec(own.z, own.w), center = vec(0.0f, 0.0f);
	if (body >= 0)
	{
		Float4 pose = poses[body];
		Float2 middle = p->local_center[body];
		Vec turn = vec(pose.z, pose.w);
		Vec arm = vec_turn(turn, vec(own.x - middle.x, own.y - middle.y));
		position = vec_add(vec(pose.x, pose.y), arm);
		rotation = vec_turn(turn, rotation);
		center = vec_neg(arm);
	}
	world_shape.x = position.x;
	world_shape.y = position.y;
	world_shape.c = rotation.x;
	world_shape.s = rotation.y;
	world_shape.center_x = center.x;
	world_shape.center_y = center.y;
	return world_shape;
}

INLINE WorldShape collidable_place(const Pools* p, int i) { return collidable_at(p, i, p->pose); }

INLINE Vec world_vertex(WorldShape world_shape, const GLOBAL Attribute* attribute, int k)
{
	Vec vertex = vec(attribute->vertices[k].x, attribute->vertices[k].y);
	return vec_add(vec(world_shape.x, world_shape.y), vec_turn(vec(world_shape.c, world_shape.s), vertex));
}

// Returns the box of a shape, enlarged by `extra`, m.
INLINE Float4 world_box(WorldShape world_shape, const GLOBAL Attribute* attribute, float extra)
{
	Float4 box = box_empty();
	for (int k = 0; k < attribute->count; ++k)
	{
		Vec v = world_vertex(world_shape, attribute, k);
		box = box_union(box, make_float4(v.x, v.y, v.x, v.y));
	}
	return box_grow(box, attribute->radius + extra);
}

// Returns COLLIDABLE_SHIFTED if static or kinematic collidable i moves, or the user moved or changed it since the last
// step. A new collidable, whose box was empty, was not moved. box: box before this step; now: current pose.
INLINE int transform_shifts(const Pools* p, int i, Float4 box, WorldShape now)
{
	WorldShape then = p->world_shape[i];
	int moved = now.x != then.x || now.y != then.y || now.c != then.c || now.s != then.s;
	return body_is_moving(p, now.body) || (moved && box.x <= box.z) ? COLLIDABLE_SHIFTED : 0;
}

// Updates world poses and boxes. Lists the collidables that left their enlarged boxes; new ones had an empty box.
LIST_KERNEL(transform, updated_list, updated_boxes)
{
	i = active_item(p, GROUPS_OF_COLLIDABLES, i);
	Float4 box = p->box[i];
	int moved = p->collidable_flags[i];
	if (p->collidable_kind[i] == KIND_DEAD)
	{
		// an empty box ends the contacts of the collidable
		p->collidable_flags[i] = COLLIDABLE_NEW_BOX;
		p->box[i] = box_empty();
		return -1;
	}

	// treats a collidable without a body as part of the ground
	WorldShape world_shape = collidable_place(p, i);
	int moves = world_shape.body >= 0;
	world_shape.body = moves ? world_shape.body : bay_ground(p, i);
	int shifts = p->step.sleep && p->collidable_kind[i] != KIND_DYNAMIC ? transform_shifts(p, i, box, world_shape) : 0;
	shifts |= moved & COLLIDABLE_CHANGED && p->step.sleep ? COLLIDABLE_SHIFTED : 0;
	if (shifts && (moved & (COLLIDABLE_SHIFTED | COLLIDABLE_CHANGED)) != COLLIDABLE_SHIFTED)
		raise_int(&p->counters->shifted, 0x7fffffff);
	p->world_shape[i] = world_shape;
	const GLOBAL Attribute* attribute = p->attribute + world_shape.attribute;

	// each box of a pair is enlarged by half of the speculative distance, because contacts begin at this distance
	Float4 tight = world_box(world_shape, attribute, 0.5f * SPECULATIVE_DISTANCE);
	float margin = attribute->margin;
	int how = p->step.small && p->collidable_kind[i] == KIND_DYNAMIC
	              ? transform_grains(p->thickness[world_shape.attribute], attribute->reach)
	              : 0;
	how |= shifts;
	if (moves)
	{
		Sweep sweep = sweep_of(p, world_shape, attribute);
		Vec path = vec_sub(sweep.path, vec_spin(sweep.turn, sweep.center));
		float swing = absolute(sweep.turn) * (attribute->reach - attribute->radius);
		float travel = absolute(path.x) + absolute(path.y) + swing;
		float room = sweep_room(&p->step, how), within = sweep_within(p, how, world_shape.body);
		if (travel > 0.5f * SWEEP_REST * room)
			how |= COLLIDABLE_MOVING;
		if (travel > 0.5f * within)
		{
			// box at the end of the step; no margin for a collidable so fast that it leaves its box in every step
			Float4 then = make_float4(tight.x + path.x, tight.y + path.y, tight.z + path.x, tight.w + path.y);
			tight = box_grow(box_union(tight, then), swing);
			margin = travel < margin ? margin : 0.0f;
			how |= COLLIDABLE_FAST;
		}
	}
	if (box_contains(box, tight))
	{
		if (moved & COLLIDABLE_NEW_BOX)
			p->old_box[i] = box;
		if (moved != how)
			p->collidable_flags[i] = how;
		return -1;
	}
	Float4 grown = box_grow(tight, margin);
	p->old_box[i] = box;
	p->box[i] = grown;
	p->collidable_flags[i] = COLLIDABLE_NEW_BOX | how;
	raise_int(&p->counters->refit, 0x7fffffff);
	// the old box covers the motion of the last step; if the new box does not overlap it, the user moved the collidable
	if (!box_overlap(box, grown))
		raise_int(&p->counters->jumped, 0x7fffffff);
	return i;
}

// Restores the old boxes after a step that stopped before it found all contacts, so that the next step finds them; and counters.
KERNEL(transform_undo)
{
	if (i == 0)
		counters_restore(p);
	int flags = p->collidable_flags[i];
	if (flags & COLLIDABLE_SHIFTED)
		p->collidable_flags[i] = (flags & ~COLLIDABLE_SHIFTED) | COLLIDABLE_CHANGED;
	if (!(flags & COLLIDABLE_NEW_BOX) || p->collidable_kind[i] == KIND_DEAD)
		return;
	p->box[i] = p->old_box[i];
	p->collidable_flags[i] = flags & COLLIDABLE_SHIFTED ? COLLIDABLE_CHANGED : 0;
}

// Writes the pose of a collidable to its render row: the current one or, if the argument is 1, that of the kernel
// interpolate. The pool world_shape has older poses: those at which the last step computed contacts.
KERNEL(render_row)
{
	WorldShape world_shape = {0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, -1, -1};
	if (p->collidable_kind[i] != KIND_DEAD)
		world_shape = collidable_at(p, i, p->argument ? p->base : p->pose);
	p->render_row[i] = world_shape;
}

#endif
