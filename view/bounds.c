// SPDX-License-Identifier: MIT
// bounds.c -- finds a box around most points of a set, without outliers.
//
// Method: John Tukey, Exploratory Data Analysis, 1977. Values beyond fences are outliers; the distance of the fences
// from the middle half of the values is a multiple of the size of that half.
#include "view/bounds.h"
#include "tools/common/median.h"
#include <math.h>
#include <stdlib.h>

// Distance of the fences from the middle half, divided by the size of that half. Tukey uses 3. The larger value 5 keeps
// bodies that slide off a heap in view.
#define FENCE 5.0f
#define OTHER 0.1f // minimum size in x or y, divided by the size in the other direction; a column has almost no width

typedef struct // sorted coordinates
{
	const float* list;
	int count;
} Sorted;

static float middle_half(Sorted s) { return s.list[s.count - 1 - s.count / 4] - s.list[s.count / 4]; }

static void find_range(Sorted s, float size, float* low, float* high)
{
	float below = s.list[s.count / 4] - FENCE * size, above = s.list[s.count - 1 - s.count / 4] + FENCE * size;
	int first = 0, last = s.count - 1;
	while (s.list[first] < below)
		++first;
	while (s.list[last] > above)
		--last;
	*low = s.list[first];
	*high = s.list[last];
}

bool bounds_find(const scree_vec* points, int count, float reach, scree_box* box)
{
	float* x = count > 0 ? malloc((size_t)count * 2 * sizeof *x) : NULL;
	if (!x)
		return false;
	float* y = x + count;
	int used = 0;
	for (int k = 0; k < count; ++k)
	{
		if (!isfinite(points[k].x) || !isfinite(points[k].y))
			continue;
		x[used] = points[k].x;
		y[used++] = points[k].y;
	}
	if (used == 0)
	{
		free(x);
		return false;
	}
	sort_floats(x, used);
	sort_floats(y, used);
	Sorted across = {x, used}, up = {y, used};
	float wide = middle_half(across), high = middle_half(up), least = 2.0f * reach;
	find_range(across, fmaxf(fmaxf(wide, OTHER * high), least), &box->lower.x, &box->upper.x);
	find_range(up, fmaxf(fmaxf(high, OTHER * wide), least), &box->lower.y, &box->upper.y);
	free(x);
	*box = (scree_box){{box->lower.x - reach, box->lower.y - reach}, {box->upper.x + reach, box->upper.y + reach}};
	return true;
}

scree_box bounds_join(scree_box a, scree_box b)
{
	return (scree_box){{fminf(a.lower.x, b.lower.x), fminf(a.lower.y, b.lower.y)},
	                   {fmaxf(a.upper.x, b.upper.x), fmaxf(a.upper.y, b.upper.y)}};
}

scree_box bounds_limit(scree_box box, scree_box around, float sizes)
{
	float x = sizes * (around.upper.x - around.lower.x), y = sizes * (around.upper.y - around.lower.y);
	return (scree_box){{fmaxf(box.lower.x, around.lower.x - x), fmaxf(box.lower.y, around.lower.y - y)},
	                   {fminf(box.upper.x, around.upper.x + x), fminf(box.upper.y, around.upper.y + y)}};
}
