// SPDX-License-Identifier: MIT
// viewport.c -- computes the part of a world that a picture shows.
#include "scene/viewport.h"
#include "tools/common/median.h"
#include <math.h>
#include <stdlib.h>

#define SHOWN_SHARE 0.995f // share of the points that lie inside the box of viewport_fit in x; also the share in y

Viewport viewport_show(scree_box view, int width, int height)
{
	double across = view.upper.x - view.lower.x, up = view.upper.y - view.lower.y;
	double room_across = fmax(width - 2 * MARGIN, 1), room_up = fmax(height - BAND - 2 * MARGIN, 1);
	double scale = fmin(room_across / across, room_up / up);
	return (Viewport){scale, view.lower.x + across / 2 - width / scale / 2,
	                  view.lower.y + up / 2 - (height - BAND) / scale / 2};
}

// Interpolates one axis of the view: in equal times the size is multiplied by equal factors, and the middle moves in
// proportion to the change of the size.
static void between(float low0, float high0, float low1, float high1, double share, float* low, float* high)
{
	double size0 = high0 - low0, size1 = high1 - low1, size = size0 * pow(size1 / size0, share);
	double done = fabs(size1 - size0) > 1e-6 * size0 ? (size - size0) / (size1 - size0) : share;
	double middle = (low0 + high0) / 2 + done * ((low1 + high1) / 2 - (low0 + high0) / 2);
	*low = (float)(middle - size / 2);
	*high = (float)(middle + size / 2);
}

scree_box viewport_between(scree_box from, scree_box to, double share)
{
	scree_box box;
	if (share <= 0 || share >= 1)
		return share <= 0 ? from : to; // at both ends, returns exactly the given box
	between(from.lower.x, from.upper.x, to.lower.x, to.upper.x, share, &box.lower.x, &box.upper.x);
	between(from.lower.y, from.upper.y, to.lower.y, to.upper.y, share, &box.lower.y, &box.upper.y);
	return box;
}

static void robust_range(float* values, int count, float* low, float* high)
{
	sort_floats(values, count);
	int outside = (int)((float)count * (1 - SHOWN_SHARE) / 2);
	*low = values[outside];
	*high = values[count - 1 - outside];
}

bool viewport_fit(const scree_vec* points, int count, float reach, scree_box* view)
{
	*view = (scree_box){{-1, -1}, {1, 1}};
	float* x = malloc((size_t)(count + 1) * 2 * sizeof(float));
	if (!x)
		return false;
	float* y = x + count;
	for (int k = 0; k < count; ++k)
	{
		x[k] = points[k].x;
		y[k] = points[k].y;
	}
	if (count > 0)
	{
		robust_range(x, count, &view->lower.x, &view->upper.x);
		robust_range(y, count, &view->lower.y, &view->upper.y);
		*view = (scree_box){{view->lower.x - 2 * reach, view->lower.y - 2 * reach},
		                    {view->upper.x + 2 * reach, view->upper.y + 2 * reach}};
	}
	free(x);
	return true;
}
