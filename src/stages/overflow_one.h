// SPDX-License-Identifier: MIT
// overflow_one.h -- who shares a body among the overflow contacts, and the sums of their shares in a fixed order.
#ifndef OVERFLOW_ONE_H
#define OVERFLOW_ONE_H
#include "stages/body.h"

// Entry i = 2 * k + side by body. Bodies that cannot move need no sum and go last.
STAGE(overflow_key)
{
	int c = p->counters->color_begin[COLORS] + i / 2;
	int body = i & 1 ? constraint_at(p, body_b, c) : constraint_at(p, body_a, c);
	Word64 name = p->body[body].inv_mass > 0.0f ? (Word64)body : (Word64)0xffffffffu;
	p->key[i] = name << 32 | (Word64)i;
}

// argument is the number of entries: binary search for the run of the sorted entry i
STAGE(overflow_order)
{
	Word64 body = p->key[i] >> 32;
	int entries = p->argument;
	p->overflow_entry[i] = body == (Word64)0xffffffffu ? -1 : (int)(p->key[i] & (Word64)0xffffffffu);
	int low = 0, high = i;
	while (low < high)
	{
		int middle = low + (high - low) / 2;
		if (p->key[middle] >> 32 < body)
			low = middle + 1;
		else
			high = middle;
	}
	int first = low;
	low = i + 1;
	high = entries;
	while (low < high)
	{
		int middle = low + (high - low) / 2;
		if (p->key[middle] >> 32 == body)
			low = middle + 1;
		else
			high = middle;
	}
	p->overflow_run[i] = make_int2(first, low);
}

STAGE(overflow_split)
{
	int entry = p->overflow_entry[i];
	if (entry < 0)
		return;
	Int2 run = p->overflow_run[i];
	float shares = (float)(run.y - run.x);
	if (entry & 1)
		p->overflow_split_b[entry / 2] = shares;
	else
		p->overflow_split_a[entry / 2] = shares;
}

// The sum is a tree of two levels: runs of OVERFLOW_CHUNK entries here, their sums in overflow_apply.
STAGE(overflow_chunk)
{
	Int2 run = p->overflow_run[i];
	if (p->overflow_entry[i] < 0 || (i - run.x) % OVERFLOW_CHUNK != 0)
		return;
	int end = i + OVERFLOW_CHUNK < run.y ? i + OVERFLOW_CHUNK : run.y;
	Real sum[4] = {0.0f, 0.0f, 0.0f, 0.0f}, delta[4];
	for (int k = i; k < end; ++k)
	{
		load_rows4((GLOBAL float*)p->overflow_delta, p->overflow_entry[k], delta);
		sum[0] += delta[0];
		sum[1] += delta[1];
		sum[2] += delta[2];
	}
	store_rows4((GLOBAL float*)p->overflow_sum, i, sum);
}

// the mean of the shares' velocities, by the first entry of each body
STAGE(overflow_apply)
{
	Int2 run = p->overflow_run[i];
	if (p->overflow_entry[i] < 0 || i != run.x)
		return;
	Real sum[4] = {0.0f, 0.0f, 0.0f, 0.0f}, chunk[4];
	for (int k = run.x; k < run.y; k += OVERFLOW_CHUNK)
	{
		load_rows4((GLOBAL float*)p->overflow_sum, k, chunk);
		sum[0] += chunk[0];
		sum[1] += chunk[1];
		sum[2] += chunk[2];
	}
	float shares = (float)(run.y - run.x);
	int entry = p->overflow_entry[i], c = p->counters->color_begin[COLORS] + entry / 2;
	int index = entry & 1 ? constraint_at(p, body_b, c) : constraint_at(p, body_a, c);
	Body b = body_gather(p, index);
	b.v = vec_add(b.v, vec(sum[0] / shares, sum[1] / shares));
	b.w = b.w + sum[2] / shares;
	body_scatter(p, index, b);
}

#endif
