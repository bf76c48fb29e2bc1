// SPDX-License-Identifier: MIT
// prepare_one.h -- prepares the state of bodies at the start of a step, and restores inertias after the step.
#ifndef PREPARE_ONE_H
#define PREPARE_ONE_H
#include "constraints/constraint_kinds.h"
#include "pools/bays.h"
#include "stages/edit/active.h"

// Clears the counters of finalize, after the host has read those of the last step. A step of length 0 has no finalize,
// so `movers` stays that of the step before.
INLINE void counters_clear(const Pools* p)
{
	p->counters->nonfinite = 0;
	p->counters->held = 0;
	if (p->step.dt > 0.0f)
		p->counters->movers = 0;
	p->counters->first_nonfinite = 0x7fffffff;
}

// argument: 1 to clear Counters.taut too, in place of body_taut.
KERNEL(solve_begin)
{
	if (i == 0)
		counters_clear(p);
	if (!SMALL_CODE && i == 0 && p->argument)
		p->counters->taut = 0; // the warm starts of this step set it again
	i = active_item(p, GROUPS_OF_BODIES, i);
	GLOBAL BodyState* body = p->body + i;
	p->base[i] = make_float4(body->vx, body->vy, body->w, 0.0f);
	body->dx = 0.0f;
	body->dy = 0.0f;
	body->da = 0.0f;
}

// Raises the inertia of a body for the step to that which the pull of joints requires (joint_taut), in member `da`.
KERNEL(body_taut)
{
	GLOBAL BodyState* body = p->body + i;
	float pull = body->da, own = body->inv_inertia;
	body->da = 0.0f;
	p->own_inertia[i] = own;
	int used = !BATCHED(p) || bay_state_of(p, i)->taut_used;
	if (used && own > 0.0f && pull * own > 1.0f && pull <= MOST_FLOAT)
		body->inv_inertia = quotient(1.0f, minimum(pull, MOST_INERTIA));
	if (i == 0)
		p->counters->taut = 0; // the warm starts of this step set it again
}

// Restores the inertia of a body after the step.
KERNEL(body_slack) { p->body[i].inv_inertia = p->own_inertia[i]; }

#endif
