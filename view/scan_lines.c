// SPDX-License-Identifier: MIT
// scan_lines.c -- draws the rays of a scene as strokes.
#include "view/scan_lines.h"
#include "scene/scan_picture.h"

scree_status scan_lines_update(Scan* scan, scree_world* world, const Camera* camera, int most)
{
	scree_box box = camera_box(camera);
	scree_status status = scan_aim(scan, world, &box, most);
	return status == SCREE_OK ? scan_cast(scan, world) : status;
}

void scan_lines_mark(const Scan* scan, Strokes* under, Strokes* over, const Camera* camera)
{
	float width = hit_width(camera->scale);
	for (int k = 0; k < scan->count; ++k)
	{
		scree_vec end = scan_end(scan, k);
		strokes_fade(under, scan->rays[k].origin, end, RAY_WIDTH, RAY_COLOR, RAY_NEAR, RAY_FAR);
		if (scan->found[k].hit)
			strokes_add(over, end, end, width, HIT_COLOR, HIT_OPAQUE);
	}
}
