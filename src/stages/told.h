// SPDX-License-Identifier: MIT
// told.h -- bodies at other poses than the user was told last, on request. No step reads or writes this.
#ifndef TOLD_H
#define TOLD_H
#include "pools/pools.h"

STAGE(told_begin)
{
	p->counters->told = 0;
	(void)i;
}

// A new row has the pose 0, whose rotation no body has.
LIST_STAGE(told_mark, told, told)
{
	Float4 now = p->pose[i], then = p->told_pose[i];
	return float_bits(now.x) != float_bits(then.x) || float_bits(now.y) != float_bits(then.y) ||
	       float_bits(now.z) != float_bits(then.z) || float_bits(now.w) != float_bits(then.w);
}

STAGE(told_key) { p->key[i] = (Word64)p->told[i]; }

// After the sort.
STAGE(told_list)
{
	Told row;
	row.body = (int)p->key[i];
	row.pose = p->pose[row.body];
	row.vx = p->body[row.body].vx;
	row.vy = p->body[row.body].vy;
	row.w = p->body[row.body].w;
	p->told_pose[row.body] = row.pose;
	p->told_row[i] = row;
}

#endif
