// SPDX-License-Identifier: MIT
// random_queries.c -- creates random shapes, poses and queries.
#include "support/random_queries.h"

scree_shape random_shape(uint64_t* seed, float scale)
{
	scree_shape shape;
	scree_vec points[6];
	float r = scale * random_between(seed, 0.2f, 1.0f);
	switch (random_below(seed, 7))
	{
	case 0:
		OK(scree_shape_make_circle((scree_vec){0.3f * r, 0.0f}, r, &shape));
		return shape;
	case 1:
		OK(scree_shape_make_capsule((scree_vec){-r, 0.1f * r}, (scree_vec){r, 0.2f * r}, 0.4f * r, &shape));
		return shape;
	case 2:
		shape = segment_shape(-r, 0.0f, 2.0f * r, r);
		return shape;
	case 3:
		shape = box_shape(r, 0.02f * scale + 0.3f * r);
		return shape;
	case 4:
		shape = box_shape(r, r);
		return shape;
	default:
		for (;;)
		{
			for (int k = 0; k < 6; ++k)
				points[k] = (scree_vec){random_between(seed, -r, r), random_between(seed, -r, r)};
			float round = random_below(seed, 2) ? 0.3f * r : 0.0f;
			if (scree_shape_make_hull(points, 6, round, &shape) == SCREE_OK)
				return shape;
		}
	}
}

scree_pose random_pose(uint64_t* seed, scree_vec center, float size)
{
	scree_vec at = {center.x + size * random_between(seed, -1.0f, 1.0f),
	                center.y + size * random_between(seed, -1.0f, 1.0f)};
	static const float right[] = {0.0f, 1.5707964f, 3.1415927f, -1.5707964f};
	bool even = random_below(seed, 3) == 0; // at multiples of 90 degrees, edges of two shapes are often parallel
	return (scree_pose){at, scree_rot_make(even ? right[random_below(seed, 4)] : random_between(seed, -3.0f, 3.0f))};
}

scree_vec random_path(uint64_t* seed, float size)
{
	float length = random_below(seed, 2) ? size : 0.1f * size;
	scree_vec path = {length * random_between(seed, -1.0f, 1.0f), length * random_between(seed, -1.0f, 1.0f)};
	if (random_below(seed, 8) == 0)
		path.x = 0.0f;
	if (random_below(seed, 8) == 0)
		path.y = 0.0f;
	return path;
}

scree_query_def random_def(uint64_t* seed)
{
	scree_query_def def = scree_query_def_default();
	if (random_below(seed, 3) == 0)
		def.kinds = 1 + (uint32_t)random_below(seed, 15);
	if (random_below(seed, 3) == 0)
		def.mask = 1 + (uint64_t)random_below(seed, 15);
	return def;
}
