// SPDX-License-Identifier: MIT
// contact_report.h -- writes reports of contacts, of one body or of events, for the host. No step reads the reports.
#ifndef CONTACT_REPORT_H
#define CONTACT_REPORT_H
#include "constraints/constraint_kinds.h"
#include "constraints/contact_report_points.h"

// Returns the impulses of contact i in the last substep, two along the normal and two across; those that a sleeping contact
// keeps; or 0.
INLINE Float4 contact_impulses(const Pools* p, int i)
{
	int c = p->contact_place[i];
	const GLOBAL ContactKept* kept = p->contact_kept + i;
	if (c >= 0)
		return make_float4(contact_row(p, normal_impulse1, c), contact_row(p, normal_impulse2, c),
		                   contact_row(p, tangent_impulse1, c), contact_row(p, tangent_impulse2, c));
	if (p->contact_flags[i] & CONTACT_ASLEEP)
		return make_float4(kept->normal_impulse1, kept->normal_impulse2, kept->tangent_impulse1,
		                   kept->tangent_impulse2);
	return make_float4(0.0f, 0.0f, 0.0f, 0.0f);
}

INLINE void contact_report_write(const Pools* p, int i, int row)
{
	ContactReport listed;
	Int2 pair = p->pair[i];
	Real a[8], b[8], manifold[16];
	int c = p->contact_place[i];
	listed.pair = pair;
	listed.feature = p->contact_feature[i];
	listed.flags = p->contact_flags[i];
	listed.color = contact_report_color(p->contact_color[i]);
	listed.unused[0] = 0.0f;
	listed.unused[1] = 0.0f;
	gather_fixed_rows8((GLOBAL float*)p->world_shape, pair.x, a);
	gather_fixed_rows8((GLOBAL float*)p->world_shape, pair.y, b);
	gather_fixed_rows8((GLOBAL float*)p->contact_manifold, 2 * i, manifold);
	gather_fixed_rows8((GLOBAL float*)p->contact_manifold, 2 * i + 1, manifold + 8);
	ContactPoints at = contact_report_points(p->attribute, a, b, manifold, listed.flags, listed.feature);
	contact_report_place(&listed, &at, a[0], a[1]);
	listed.impulse = contact_impulses(p, i);
	listed.detail = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
	if (c >= 0 && p->step.details)
		listed.detail = make_float4(contact_rare(p, total_impulse1, c), contact_rare(p, total_impulse2, c),
		                            contact_rare(p, approach1, c), contact_rare(p, approach2, c));
	p->contact_report[row] = listed;
}

// Item: a contact slot, or the end of the scan. Marks the touching contacts of a body for the scan. argument: the body.
KERNEL(contact_mark)
{
	int wanted = 0;
	if (i < p->counters->contacts && p->pair[i].x >= 0)
	{
		Int2 bodies = p->contact_bodies[i];
		wanted = (p->contact_flags[i] & (CONTACT_TOUCHING | CONTACT_DETECTED | CONTACT_PENDING)) == CONTACT_TOUCHING &&
		         (bodies.x == p->argument || bodies.y == p->argument);
	}
	p->scan[i] = wanted;
}

// Writes the report of slot i if it is marked: the scan increases from i to i + 1. argument: maximum number of reports.
KERNEL(contact_list)
{
	int row = p->scan[i];
	if (p->scan[i + 1] == row || row >= p->argument)
		return;
	contact_report_write(p, i, row);
}

#endif
