// SPDX-License-Identifier: MIT
// contact_loads.c -- sums the contact forces of each body, for the paint that colors bodies by force.
#include "view/contact_loads.h"
#include <math.h>
#include <string.h>

#define WITHIN 0.995f // fraction of the positive forces that the range includes
#define IDLE   4.0f   // a range is made smaller if it is more than IDLE times as large as needed
#define BINS   2048   // number of bins, by the upper 12 bits of a float, whose sign is 0: 8 bins for each power of two

void loads_sum(const scree_contact* contacts, int contact_count, float substep, float* forces, int count)
{
	for (int k = 0; k < contact_count; ++k)
	{
		const scree_contact* c = &contacts[k];
		const scree_body bodies[2] = {c->body_a, c->body_b};
		float force = 0.0f;
		for (int n = 0; n < c->count; ++n)
			force += fmaxf(c->points[n].normal_impulse, 0.0f) / substep;
		for (int side = 0; side < 2; ++side)
			if (!scree_body_is_null(bodies[side]) && (int)bodies[side].index < count)
				forces[bodies[side].index] += force;
	}
}

// Returns the upper end of the bin that contains the quantile WITHIN of the positive forces; 0 if no force is positive.
static float quantile(const float* forces, int count)
{
	int bins[BINS] = {0}, all = 0, passed = 0;
	for (int k = 0; k < count; ++k)
	{
		uint32_t bits;
		memcpy(&bits, &forces[k], sizeof bits);
		if (!(forces[k] > 0.0f) || !isfinite(forces[k]))
			continue;
		++bins[bits >> 20];
		++all;
	}
	for (uint32_t bin = 0; bin < BINS; ++bin)
	{
		passed += bins[bin];
		if (all == 0 || (float)passed < WITHIN * (float)all)
			continue;
		uint32_t bits = (bin + 1) << 20;
		float end;
		memcpy(&end, &bits, sizeof end);
		return end;
	}
	return 0.0f;
}

float loads_range(const float* forces, int count, float last)
{
	float needed = quantile(forces, count);
	if (needed <= 0.0f || !isfinite(needed))
		return last > 0.0f ? last : 1.0f;
	if (last >= needed && last <= IDLE * needed)
		return last;
	float power = powf(10.0f, floorf(log10f(needed)));
	const float steps[] = {1.0f, 2.0f, 5.0f, 10.0f};
	int k = 0;
	while (k < 3 && steps[k] * power < needed)
		++k;
	return steps[k] * power;
}
