// SPDX-License-Identifier: MIT
// bay_visit.h -- finds the collidables that are in the sensors of the worlds of a batch, counts, hashes and copies them.
//
// A bay has a list of its sensors, as indices within the world, and for each of them one bit for each collidable. A bit is
// 1 if the collidable was in the sensor at the end of the last step: these are the visits that a world alone lists
// (sensor.h). They are part of its hash, and they outlive changes between steps, so the bits are kept, and are not computed
// from the poses when they are needed.
#ifndef BAY_VISIT_H
#define BAY_VISIT_H
#include "pools/bays.h"
#include "stages/read/sensor.h"

// Returns the list of sensors of a bay; the bits follow it.
INLINE GLOBAL Word* visit_list(const Pools* p, int bay)
{
	const Bays* bays = &p->step.bays;
	return p->bay_visit + bay * visit_size(bays->sensors, bays->collidables);
}

// Returns whether a collidable is in a sensor at their poses. a: that of the sensor. The tests are those of sensor_visit.
INLINE int visit_lasts(const Pools* p, int sensor, WorldShape a, int visitor, WorldShape b)
{
	Frame end = sensor_frame(a, b);
	Vec normal;
	return sensor_stays(p, sensor, a, visitor, b, end) || !(sensor_apart(p, a, b, end, &normal) > 0.0f);
}

// Returns a word of the bits of a sensor. first: first collidable of the bay; name: the sensor within the world; others:
// the collidable within the world that has the first bit.
INLINE Word visit_bits(const Pools* p, int first, int name, int others)
{
	int sensor = first + name, end = p->step.bays.collidables < others + 32 ? p->step.bays.collidables : others + 32;
	Word reports = p->filter[sensor].reports, kinds = sensor_kinds(reports), bits = 0;
	if (p->collidable_kind[sensor] == KIND_DEAD || !(reports & SENSOR_BITS))
		return 0;
	WorldShape at = collidable_place(p, sensor);
	Float4 box = query_box_at(p, at);
	for (int k = others; k < end; ++k)
	{
		int visitor = first + k, kind = p->collidable_kind[visitor];
		if (kind == KIND_DEAD || k == name || !(query_kind(kind) & kinds) || apart_by(p, sensor, visitor, APART_SEEN))
			continue;
		WorldShape place = collidable_place(p, visitor);
		if (box_overlap(box, query_box_at(p, place)) && visit_lasts(p, sensor, at, visitor, place))
			bits |= 1u << (k - others);
	}
	return bits;
}

// Item: a word of the bits of a sensor in a live bay, after a step.
KERNEL(bay_visit)
{
	const Bays* bays = &p->step.bays;
	int words = visit_words(bays->collidables), size = bays->sensors * words;
	int bay = i / size, at = i - bay * size, sensor = at / words;
	GLOBAL Word* list = visit_list(p, bay);
	Word name = list[sensor], bits = 0;
	if (name != VISIT_NONE)
		bits = visit_bits(p, bay * bays->collidables, (int)name, 32 * (at - sensor * words));
	list[bays->sensors + at] = bits;
}

// Item: a word of a copy of a world.
KERNEL(bay_copy_visit)
{
	const Bays* bays = &p->step.bays;
	int size = visit_size(bays->sensors, bays->collidables), n = i / size, k = i - n * size;
	Int2 copy = p->bay_copy[n];
	visit_list(p, copy.y)[k] = visit_list(p, copy.x)[k];
}

// Returns the number of collidables in a sensor, a collidable within the world.
INLINE int visit_count(const Pools* p, int bay, int name)
{
	int sensors = p->step.bays.sensors, words = visit_words(p->step.bays.collidables), count = 0;
	const GLOBAL Word* list = visit_list(p, bay);
	for (int s = 0; s < sensors; ++s)
	{
		if (list[s] != (Word)name)
			continue;
		for (int k = 0; k < words; ++k)
			for (Word bits = list[sensors + s * words + k]; bits; bits &= bits - 1u)
				++count;
	}
	return count;
}

// Returns the sum of the hashes of the visits of a world, as world_hidden_hash adds them.
INLINE Word64 visit_hash(const Pools* p, int bay)
{
	int sensors = p->step.bays.sensors, words = visit_words(p->step.bays.collidables);
	const GLOBAL Word* list = visit_list(p, bay);
	Word64 sum = 0;
	for (int s = 0; s < sensors; ++s)
		for (int k = 0; k < words; ++k)
		{
			Word bits = list[sensors + s * words + k];
			for (int n = 32 * k; bits; bits >>= 1, ++n)
				if (bits & 1u)
					sum += hash_mix(hash_int(hash_begin(HASH_VISIT, (int)list[s]), n));
		}
	return sum;
}

#endif
