// SPDX-License-Identifier: MIT
// one_way.h -- one-way platforms: tests whether a visitor is on the side from which a platform is solid.
//
// docs/design/rules.md has the reasons. A visitor becomes held when it is above the platform: none of its
// points is below an upper side by more than a small slop, and it is over this side or gets there in the step. It stays
// held while it touches the platform; without a touch, until it is below or beside the platform, because a tilted plank
// may reach below the platform before the two touch.
//
// This work is based on:
// Erin Catto, Box2D's sample Platform; Rapier's update_as_oneway_platform: a state for each contact.
#ifndef ONE_WAY_H
#define ONE_WAY_H
#include "stages/geometry/sweep.h"

// ONE_WAY_SLOP, m: depth up to which a visitor counts as above. It exceeds a fall in a step of 1/30 s, and the depth to
// which loads press bodies into a platform. The others are fractions of the visitor's thickness. ONE_WAY_SHARE:
// limit of the slop, so that a thin visitor from below does not count as above when it touches. ONE_WAY_FRESH: slop of
// a pair whose boxes were apart in the last step: continuous collision stops a visitor at CONTINUOUS_DEPTH.
#define ONE_WAY_SLOP  SPECULATIVE_DISTANCE
#define ONE_WAY_SHARE 0.5f
#define ONE_WAY_FRESH 0.3f
#define ONE_WAY_TOUCH 1.0e-9f // m: minimum depth assumed for a visitor that touches a platform

// states of a contact before the test
#define ONE_WAY_NEW  0 // boxes did not overlap in the last step, or the visitor was beside and above an upper side
#define ONE_WAY_PAST 1 // the platform let the visitor through
#define ONE_WAY_HELD 2 // the platform held the visitor, but the two do not touch
// cosine: for an upper side, the dot product of its normal and the platform's direction `up` is larger than this;
// rounding must not make the walls of a box upper sides
#define ONE_WAY_UPPER 0.1f

// heights of a visitor relative to a platform
#define ONE_WAY_LOW   0
#define ONE_WAY_HIGH  1 // above the height of an upper side, but beside it
#define ONE_WAY_ABOVE 2 // over an upper side, or it gets there in the step

typedef struct // extent of a shape along a direction, and across it, m
{
	float low, high, left, right;
} OneWaySpan;

RARE OneWaySpan one_way_span(const GLOBAL Attribute* shape, Frame f, Vec n)
{
	Vec corner = frame_point(f, shape_corner(shape, 0));
	OneWaySpan span;
	span.low = span.high = vec_dot(n, corner);
	span.left = span.right = vec_cross(n, corner);
	for (int k = 1; k < shape->count; ++k)
	{
		corner = frame_point(f, shape_corner(shape, k));
		float along = vec_dot(n, corner), across = vec_cross(n, corner);
		span.low = minimum(span.low, along);
		span.high = maximum(span.high, along);
		span.left = minimum(span.left, across);
		span.right = maximum(span.right, across);
	}
	span.low = span.low - shape->radius;
	span.high = span.high + shape->radius;
	span.left = span.left - shape->radius;
	span.right = span.right + shape->radius;
	return span;
}

INLINE int one_way_meet(OneWaySpan a, OneWaySpan b) { return a.left <= b.right && b.left <= a.right; }

typedef struct // depth up to which a visitor counts as above, m
{
	float slop; // value for the current poses
	float late; // value for later poses of the step, at which the visitor comes down to the side
} OneWayDepth;

// Returns the height (ONE_WAY_*) of a visitor relative to a side. n: normal of the side. way, m: motion of the visitor
// relative to the side in the step.
RARE int one_way_over(OneWaySpan side, OneWaySpan visitor, Vec n, Vec way, OneWayDepth depth)
{
	float gap = visitor.low - side.high, closes = -vec_dot(n, way), slides = vec_cross(n, way), from = 0.0f, to = 1.0f;
	if (!(gap >= -depth.slop))
		return ONE_WAY_LOW;
	// a visitor that is above the side by more than the slop, and reaches its height in this step, is tested where it
	// is from then until its depth is `late`; all others are tested over the whole step
	if (gap > depth.slop && closes > gap)
	{
		from = quotient(gap, closes);
		to = minimum(quotient(gap + depth.late, closes), 1.0f);
	}
	visitor.left += minimum(from * slides, to * slides);
	visitor.right += maximum(from * slides, to * slides);
	return one_way_meet(side, visitor) ? ONE_WAY_ABOVE : ONE_WAY_HIGH;
}

// Returns whether n is the normal of an upper side, but not `up`: the test of the whole platform covers that side.
INLINE int one_way_upper(Vec n, Vec up) { return vec_dot(n, up) > ONE_WAY_UPPER && !(n.x == up.x && n.y == up.y); }

typedef struct // extents of a platform and a visitor along the direction `up`, in the frame of the platform
{
	OneWaySpan platform, visitor;
} OneWayWhole;

INLINE OneWayWhole one_way_whole(const GLOBAL Attribute* platform, Vec up, const GLOBAL Attribute* visitor, Frame f)
{
	OneWayWhole whole;
	whole.platform = one_way_span(platform, frame_at(vec(0.0f, 0.0f), vec(1.0f, 0.0f)), up);
	whole.visitor = one_way_span(visitor, f, up);
	return whole;
}

INLINE OneWaySpan one_way_grow(OneWaySpan span, float margin)
{
	span.low -= margin;
	span.left -= margin;
	span.right += margin;
	return span;
}

// Returns the largest of a visitor's heights relative to the whole platform and to each of its upper sides. f: pose of
// the visitor in the frame of the platform. margin, m: distance by which the visitor is enlarged.
INLINE int one_way_height(const GLOBAL Attribute* platform, Vec up, const GLOBAL Attribute* visitor, Frame f,
                          OneWayWhole whole, float margin, Vec way, OneWayDepth depth)
{
	Frame own = frame_at(vec(0.0f, 0.0f), vec(1.0f, 0.0f));
	int most = one_way_over(whole.platform, one_way_grow(whole.visitor, margin), up, way, depth);
	for (int k = 0; platform->count > 1 && k < platform->count; ++k)
	{
		Vec n = shape_normal(platform, k);
		if (!one_way_upper(n, up))
			continue;
		int height = one_way_over(one_way_span(platform, own, n), one_way_grow(one_way_span(visitor, f, n), margin), n,
		                          way, depth);
		most = height > most ? height : most;
	}
	return most;
}

// Returns the depth up to which visitor b counts as above. A load may press b into the platforms that hold it, so the
// next platform accepts b at that depth, plus the depth that continuous collision allows for a visitor from afar.
INLINE OneWayDepth one_way_depth(const Pools* p, WorldShape b, int known, float swing)
{
	float thickness = p->thickness[b.attribute], sunk = bits_float(p->sunk[b.body]);
	OneWayDepth depth = {minimum(ONE_WAY_SLOP, ONE_WAY_SHARE * thickness), swing};
	if (known == ONE_WAY_NEW || sunk > 0.0f)
		depth.slop = maximum(depth.slop, sunk + ONE_WAY_FRESH * thickness);
	if (sunk > 0.0f)
		depth.late = depth.slop + swing;
	return depth;
}

typedef struct // position of a visitor relative to a platform
{
	int height; // ONE_WAY_LOW, ONE_WAY_HIGH or ONE_WAY_ABOVE
	int below, beside;
} OneWayPlace;

INLINE Frame one_way_frame(WorldShape a, WorldShape b)
{
	Vec axes = vec(a.c, a.s);
	return frame_at(vec_turn_back(axes, vec(b.x - a.x, b.y - a.y)), vec_turn_back(axes, vec(b.c, b.s)));
}

INLINE Vec one_way_up(const Pools* p, WorldShape a)
{
	return vec(p->rule[a.attribute].up_x, p->rule[a.attribute].up_y);
}

// Returns the current position of visitor b relative to platform a. way, m: displacement of b relative to a in the
// step, in the world. swing, m: largest additional displacement of a point of b. known: state before the test.
RARE OneWayPlace one_way_place(const Pools* p, WorldShape a, WorldShape b, Vec way, float swing, int known)
{
	const GLOBAL Attribute* shape_a = p->attribute + a.attribute;
	const GLOBAL Attribute* shape_b = p->attribute + b.attribute;
	Vec up = one_way_up(p, a);
	Frame f = one_way_frame(a, b);
	way = vec_turn_back(vec(a.c, a.s), way);
	OneWayWhole whole = one_way_whole(shape_a, up, shape_b, f);
	OneWayPlace place;
	place.height = one_way_height(shape_a, up, shape_b, f, whole, 0.0f, way, one_way_depth(p, b, known, swing));
	place.below = whole.visitor.high < whole.platform.high;
	place.beside = !one_way_meet(whole.platform, whole.visitor);
	return place;
}

// m: Returns the depth of visitor b in platform a, by which b was held; 0 if b has left. The depth is measured from the
// upper side with the least depth. It is at most the thickness of b, because the middle of b is outside the platform.
RARE float one_way_sunk(const Pools* p, WorldShape a, WorldShape b)
{
	const GLOBAL Attribute* platform = p->attribute + a.attribute;
	const GLOBAL Attribute* visitor = p->attribute + b.attribute;
	Vec up = one_way_up(p, a);
	Frame own = frame_at(vec(0.0f, 0.0f), vec(1.0f, 0.0f)), f = one_way_frame(a, b);
	OneWayWhole whole = one_way_whole(platform, up, visitor, f);
	float depth = minimum(whole.platform.high - whole.visitor.low, p->thickness[b.attribute]);
	if (whole.visitor.high < whole.platform.high || !one_way_meet(whole.platform, whole.visitor) || !(depth > 0.0f))
		return 0.0f;
	for (int k = 0; platform->count > 1 && k < platform->count; ++k)
	{
		Vec n = shape_normal(platform, k);
		if (one_way_upper(n, up))
			depth = minimum(depth, one_way_span(platform, own, n).high - one_way_span(visitor, f, n).low);
	}
	return depth;
}

// Returns whether another collidable of b's body is neither above platform a nor beside it. Then b is not held: a
// platform holds all collidables of a body or none.
INLINE int one_way_through(const Pools* p, WorldShape a, int b, Vec way, float swing, int known)
{
	for (int k = p->continuous_body[p->collidable_body[b]].first; k > 0; k = p->next_collidable[k - 1])
	{
		if (k - 1 == b || p->collidable_kind[k - 1] & KIND_SENSOR)
			continue;
		OneWayPlace place = one_way_place(p, a, p->world_shape[k - 1], way, swing, known);
		if (place.height != ONE_WAY_ABOVE && !place.beside)
			return 1;
	}
	return 0;
}

INLINE int one_way_is(const Pools* p, int a) { return p->rule[p->collidable_attribute[a]].one_way; }

// Returns ONE_WAY_HELD if platform a holds b in the step, else the next state of the contact. known: current state.
INLINE int one_way_finds(const Pools* p, int a, int b, Vec way, float swing, int known)
{
	WorldShape platform = p->world_shape[a];
	OneWayPlace place = one_way_place(p, platform, p->world_shape[b], way, swing, known);
	int above = place.height == ONE_WAY_ABOVE;
	if (known == ONE_WAY_HELD ? above || !(place.below || place.beside)
	                          : above && !one_way_through(p, platform, b, way, swing, known))
		return ONE_WAY_HELD;
	return place.height == ONE_WAY_HIGH ? ONE_WAY_NEW : ONE_WAY_PAST;
}

#endif
