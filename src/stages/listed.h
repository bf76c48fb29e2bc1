// SPDX-License-Identifier: MIT
// listed.h -- the touching contacts of one body, side by side for the host to read. No step reads them.
#ifndef LISTED_H
#define LISTED_H
#include "constraints/kinds.h"

// Item i is a contact slot, plus one item for the end of the scan. argument is the body.
STAGE(contact_mark)
{
	int wanted = 0;
	if (i < p->counters->contacts && p->pair[i].x >= 0)
	{
		Int2 bodies = p->contact_bodies[i];
		wanted = (p->contact_flags[i] & (CONTACT_TOUCHING | CONTACT_DETECTED)) == CONTACT_TOUCHING &&
		         (bodies.x == p->argument || bodies.y == p->argument);
	}
	p->scan[i] = wanted;
}

// After the scan: slot i is listed where the scan rises. argument is the number of rows that there is room for.
STAGE(contact_list)
{
	int row = p->scan[i];
	if (p->scan[i + 1] == row || row >= p->argument)
		return;
	Listed listed;
	int c = p->contact_place[i];
	listed.pair = p->pair[i];
	listed.feature = p->contact_feature[i];
	listed.flags = p->contact_flags[i];
	listed.color = p->contact_color[i];
	listed.place = c;
	listed.unused = 0;
	listed.impulse = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
	if (c >= 0)
		listed.impulse = make_float4(contact_row(p, normal_impulse1, c), contact_row(p, normal_impulse2, c),
		                             contact_row(p, tangent_impulse1, c), contact_row(p, tangent_impulse2, c));
	listed.detail = make_float4(0.0f, 0.0f, 0.0f, 0.0f);
	if (c >= 0 && p->step.details)
		listed.detail = make_float4(contact_rare(p, total_impulse1, c), contact_rare(p, total_impulse2, c),
		                            contact_rare(p, approach1, c), contact_rare(p, approach2, c));
	listed.manifold = p->contact_manifold[i];
	listed.a = p->world_shape[listed.pair.x];
	listed.b = p->world_shape[listed.pair.y];
	p->listed[row] = listed;
}

#endif
