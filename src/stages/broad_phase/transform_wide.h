// SPDX-License-Identifier: MIT
// transform_wide.h -- computes what transform.h does, for several collidables at once.
//
// The operations are those of the kernel for one collidable, in the same order, so the bits are equal.
#ifndef TRANSFORM_WIDE_H
#define TRANSFORM_WIDE_H
#include "constraints/sweep_closing.h"
#include "stages/broad_phase/transform_grain.h"
#include "stages/edit/active.h"

typedef struct // boxes of LANES collidables
{
	Real x, y, z, w; // as in a Float4
} Boxes;

INLINE Boxes boxes_grow(Boxes b, Real by)
{
	Boxes grown = {b.x - by, b.y - by, b.z + by, b.w + by};
	return grown;
}

INLINE Boxes boxes_union(Boxes a, Boxes b)
{
	Boxes sum = {minimum(a.x, b.x), minimum(a.y, b.y), maximum(a.z, b.z), maximum(a.w, b.w)};
	return sum;
}

INLINE Boxes boxes_blend(Boxes a, Boxes b, Int c)
{
	Boxes chosen = {blend(a.x, b.x, c), blend(a.y, b.y, c), blend(a.z, b.z, c), blend(a.w, b.w, c)};
	return chosen;
}

INLINE Int boxes_contain(Boxes outer, Boxes inner)
{
	return (outer.x <= inner.x) & (outer.y <= inner.y) & (inner.z <= outer.z) & (inner.w <= outer.w);
}

INLINE Int boxes_overlap(Boxes a, Boxes b) { return (a.x <= b.z) & (b.x <= a.z) & (a.y <= b.w) & (b.y <= a.w); }

INLINE Boxes boxes_load(const GLOBAL Float4* boxes, int i)
{
	Real rows[4];
	load_rows4((const GLOBAL float*)boxes, i, rows);
	Boxes b = {rows[0], rows[1], rows[2], rows[3]};
	return b;
}

INLINE void boxes_store(GLOBAL Float4* boxes, int i, Boxes b, Int wanted)
{
	Real rows[4] = {b.x, b.y, b.z, b.w};
	scatter_rows4((GLOBAL float*)boxes, indices(i), rows, wanted);
}

// Returns the boxes of shapes, enlarged by `extra`, m. shape: indices of their attributes.
INLINE Boxes boxes_of(const Pools* p, Int shape, Vec place, Vec rotation, Real extra)
{
	Boxes box = {splat(EMPTY_LOW), splat(EMPTY_LOW), splat(EMPTY_HIGH), splat(EMPTY_HIGH)};
	Int count = gather_int(&p->attribute->count, shape * (int)(sizeof(Attribute) / sizeof(int)));
	for (int k = 0; lane_bits(count > k); ++k)
	{
		Vec vertex;
		gather_pairs((const GLOBAL float*)p->attribute, shape * (int)(sizeof(Attribute) / sizeof(Float2)) + k,
		             &vertex.x, &vertex.y);
		Vec v = vec_add(place, vec_turn(rotation, vertex));
		Boxes at = {v.x, v.y, v.x, v.y};
		box = boxes_blend(box, boxes_union(box, at), count > k);
	}
	return boxes_grow(box, sweep_shape(&p->attribute->radius, shape) + extra);
}

// Returns the ground of the worlds of collidables i to i + LANES - 1.
RARE Int transform_grounds(const Pools* p, int i)
{
	Int ground = 0 * indices(i);
	for (int k = 0; k < LANES && BATCHED(p); ++k)
		ground[k] = bay_ground(p, i + k);
	return ground;
}

// Returns sweep_within for bodies.
RARE Real transform_within(const Pools* p, Int moved, Int body)
{
	Real fall = splat(p->step.fall);
	for (int k = 0; k < LANES && GRAVITY_VARIES(p); ++k)
		fall[k] = fall_of(p, body[k]);
	return maximum(SPECULATIVE_DISTANCE * sweep_room(&p->step, moved), fall);
}

// Returns COLLIDABLE_SHIFTED for static or kinematic collidables that move, or that the user moved or changed since the
// last step. there: lanes with collidables; moved: flags; v, w: velocities; now: current poses.
RARE Int transform_shifts_wide(const Pools* p, int i, Int there, Int moved, Int kind, Boxes box, Vec v, Real w,
                               const Real now[4])
{
	Real then[8], zero = splat(0.0f);
	load_rows8((GLOBAL float*)p->world_shape, i, then);
	Int differs = (now[0] != then[0]) | (now[1] != then[1]) | (now[2] != then[2]) | (now[3] != then[3]);
	Int moving = (v.x != zero) | (v.y != zero) | (w != zero) | (differs & (box.x <= box.z));
	Int shifts = there & ((moving & (kind != KIND_DYNAMIC)) | ((moved & COLLIDABLE_CHANGED) != 0));
	if (lane_bits(shifts & ((moved & (COLLIDABLE_SHIFTED | COLLIDABLE_CHANGED)) != COLLIDABLE_SHIFTED)))
		raise_int(&p->counters->shifted, 0x7fffffff);
	return shifts & COLLIDABLE_SHIFTED;
}

WIDE_LIST_KERNEL(transform, updated_list, updated_boxes)
{
	i = active_item(p, GROUPS_OF_COLLIDABLES, i);
	Int kind = load_int(p->collidable_kind, i), there = kind != KIND_DEAD, moved = load_int(p->collidable_flags, i);
	Int body = load_int(p->collidable_body, i) & there, shape = load_int(p->collidable_attribute, i) & there;
	Boxes box = boxes_load(p->box, i);
	Int moves = body >= 0;
	if (lane_bits(moves == 0))
		body = blend_int(transform_grounds(p, i), body, moves);

	// world poses: those of collidables without a body are their own
	Real own[4], pose[4], row[8], now[8];
	load_rows4((GLOBAL float*)p->collidable_pose, i, own);
	gather_rows4((GLOBAL float*)p->pose, body, pose);
	gather_rows8((GLOBAL float*)p->body, body, row);
	Vec middle, turn = vec(pose[2], pose[3]);
	gather_pairs((const GLOBAL float*)p->local_center, body, &middle.x, &middle.y);
	Vec arm = vec_turn(turn, vec(own[0] - middle.x, own[1] - middle.y)), rotation = vec(own[2], own[3]);
	Vec place = vec_blend(vec(own[0], own[1]), vec_add(vec(pose[0], pose[1]), arm), moves);
	rotation = vec_blend(rotation, vec_turn(turn, rotation), moves);
	Vec center = vec_blend(vec(splat(0.0f), splat(0.0f)), vec_neg(arm), moves);
	now[0] = place.x;
	now[1] = place.y;
	now[2] = rotation.x;
	now[3] = rotation.y;
	now[4] = center.x;
	now[5] = center.y;
	now[6] = bits_real(shape);
	now[7] = bits_real(body);

	Real reach = sweep_shape(&p->attribute->reach, shape), radius = sweep_shape(&p->attribute->radius, shape);
	Int how = 0 * kind;
	if (p->step.small)
		how = (kind == KIND_DYNAMIC) & transform_grains(gather(p->thickness, shape), reach);
	if (p->step.sleep)
		how = how | transform_shifts_wide(p, i, there, moved, kind, box, vec(row[0], row[1]), row[2], now);
	scatter_rows4of8((GLOBAL float*)p->world_shape, indices(i), now, there);
	scatter_rows4of8((GLOBAL float*)p->world_shape + 4, indices(i), now + 4, there);

	Boxes tight = boxes_of(p, shape, place, rotation, splat(0.5f * SPECULATIVE_DISTANCE));
	Real margin = sweep_shape(&p->attribute->margin, shape);
	Sweep sweep = sweep_with(sweep_advance_of(&p->step, vec(row[0], row[1]), row[2]), center, reach - radius);
	Vec path = vec_sub(sweep.path, vec_spin(sweep.turn, sweep.center));
	Real swing = absolute(sweep.turn) * (reach - radius);
	Real travel = absolute(path.x) + absolute(path.y) + swing;
	Real room = sweep_room(&p->step, how);
	Real within = p->step.small ? transform_within(p, how, body) : splat(SPECULATIVE_DISTANCE);
	Int moving = moves & (travel > 0.5f * SWEEP_REST * room), fast = moves & (travel > 0.5f * within);
	how = how | (moving & COLLIDABLE_MOVING) | (fast & COLLIDABLE_FAST);
	if (lane_bits(fast))
	{
		Boxes then = {tight.x + path.x, tight.y + path.y, tight.z + path.x, tight.w + path.y};
		tight = boxes_blend(tight, boxes_grow(boxes_union(tight, then), swing), fast);
		margin = blend(margin, blend(splat(0.0f), margin, travel < margin), fast);
	}

	Int inside = boxes_contain(box, tight), leaves = there & (inside == 0);
	Boxes grown = boxes_grow(tight, margin);
	Int saved = leaves | (there & ((moved & COLLIDABLE_NEW_BOX) != 0));
	if (lane_bits(saved))
		boxes_store(p->old_box, i, box, saved);
	how = blend_int(how, how | COLLIDABLE_NEW_BOX, inside == 0);
	store_int(p->collidable_flags, i, blend_int(0 * how + COLLIDABLE_NEW_BOX, how, there));
	Int changed = leaves | (there == 0);
	if (!lane_bits(changed))
		return 0;
	Boxes empty = {splat(EMPTY_LOW), splat(EMPTY_LOW), splat(EMPTY_HIGH), splat(EMPTY_HIGH)};
	boxes_store(p->box, i, boxes_blend(empty, grown, there), changed);
	Word bits = lane_bits(leaves);
	if (bits == 0)
		return 0;
	raise_int(&p->counters->refit, 0x7fffffff);
	if (lane_bits(leaves & (boxes_overlap(box, grown) == 0)))
		raise_int(&p->counters->jumped, 0x7fffffff);
	int count = 0;
	for (; bits != 0; bits &= bits - 1)
		found[count++] = i + lowest_bit(bits);
	return count;
}

#endif
