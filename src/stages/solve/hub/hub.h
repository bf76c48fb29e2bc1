// SPDX-License-Identifier: MIT
// hub.h -- solves each hub, a body with many contacts, exactly and together with all of these contacts, its spokes.
//
// This work is based on:
// Richard Tonge, Feodor Benevolenski, Andrey Voroshilov, Mass Splitting for Jitter-Free Parallel Rigid Body Simulation,
// 2012: mass splitting. A body that several hubs push at once is split into parts.
//
// Each spoke responds to the hub's velocity (spoke_answer.h). The sums of the responses and of their derivatives give
// three equations for the hub, which Newton's method solves. docs/design/hubs.md has the formulas.
#ifndef HUB_H
#define HUB_H
#include "constraints/schedule.h"
#include "stages/solve/hub/spoke_answer.h"

// Sums over spokes have a fixed order on every device: HUB_COLUMNS columns, each over every HUB_COLUMNS-th spoke, then
// a reduction by halves. A work-group of a GPU has as many work-items as there are columns.
#define HUB_LEVELS  8
#define HUB_COLUMNS (1 << HUB_LEVELS)

#define HUB_ROUNDS 2       // maximum number of rounds of Newton's method
#define HUB_CLOSE  1.0e-5f // the rounds end if Newton's step is at most this fraction of the velocity (hub_found)

#define HUB_GYRATION 1.0e13f // m^2: limit of inertia / mass; its product with HUB_SPEED squared is finite

// loops over the columns, and over the spokes k of hub h in column c
#define HUB_EACH_COLUMN(c, h) for (int c = group_lane(); c < HUB_COLUMNS && c < (h)->count; c += group_width())
#define HUB_EACH_OF(k, c, h)  for (int k = (h)->first + c; k < (h)->first + (h)->count; k += HUB_COLUMNS)

// Returns the sum of 16 numbers that are `stride` apart, added by halves. Numbers from index `used` on count as 0.
INLINE float hub_halve(const LOCAL float* x, int stride, int used)
{
	float sum[16];
	for (int j = 0; j < 16; ++j)
		sum[j] = j < used ? x[j * stride] : 0.0f;
	for (int j = 0; j < 8; ++j)
		sum[j] += sum[j + 8];
	for (int j = 0; j < 4; ++j)
		sum[j] += sum[j + 4];
	return (sum[0] + sum[2]) + (sum[1] + sum[3]);
}

// Adds up the columns of each sum by halves, with one worker. The totals are then in column 0.
INLINE void hub_add_columns(int used, int sums, LOCAL float* bench)
{
	for (int span = HUB_COLUMNS / 2; span > 0; span /= 2)
	{
		for (int q = 0; q < sums && span < used; ++q)
		{
			LOCAL float* column = bench + q * HUB_COLUMNS;
			int c = 0;
			for (; span >= LANES && c < span && c + span < used; c += LANES)
				store(column + c, 0, load(column + c, 0) + load(column + c, span));
			for (; c < span && c + span < used; ++c)
				column[c] += column[c + span];
		}
		used = used < span ? used : span;
	}
}

// Adds up the columns in local memory by halves, for each sum. A work-group does this in two rounds, each over 16
// numbers. Barriers are few and depend on no condition; otherwise an OpenCL compiler for CPUs would take many minutes.
INLINE_MEET void hub_add_up(const Hub* h, int sums, LOCAL float* bench, float sum[HUB_SUMS])
{
	int used = h->count < HUB_COLUMNS ? h->count : HUB_COLUMNS, wide = group_width() > LANES;
	// 17 instead of 16 avoids bank conflicts in local memory
	int stride = wide ? 17 : HUB_COLUMNS;
	LOCAL float *half_way = bench + HUB_SUMS * HUB_COLUMNS, *total = wide ? half_way : bench;
	for (int round = 0; round < 2; ++round)
	{
		bench_meet();
		if (!wide && round == 0)
			hub_add_columns(used, sums, bench);
		for (int k = group_lane(); wide && round == 0 && k < 16 * sums; k += group_width())
		{
			int c = k & 15;
			half_way[(k >> 4) * 17 + c] =
			    hub_halve(bench + (k >> 4) * HUB_COLUMNS + c, HUB_COLUMNS / 16, (used - c + 15) / 16);
		}
		for (int k = group_lane(); wide && round == 1 && k < sums; k += group_width())
			half_way[k * 17] = hub_halve(half_way + k * 17, 1, 16);
	}
	bench_meet();

	// adding 0 removes the sign of a zero, which would depend on the number of columns
	for (int q = 0; q < HUB_SUMS; ++q)
		sum[q] = q < sums ? total[q * stride] + 0.0f : 0.0f;
}

// Prepares all spokes or, if `warm` is set, warm starts them. Stores the sums of the impulses on the hub, by columns.
INLINE void hub_pose(const Pools* p, const Hub* h, int what, int warm, LOCAL float* bench)
{
	HUB_EACH_COLUMN(c, h)
	{
		Real push[3] = {splat(0.0f), splat(0.0f), splat(0.0f)};
		HUB_EACH_OF(i, c, h)
		if (warm)
			spoke_warm(p, h, i, what, push);
		else
			spoke_pose(p, h, i, what, push);
		for (int q = 0; q < 3; ++q)
			store(bench + q * HUB_COLUMNS, c, push[q]);
	}
}

// Sums the responses of all spokes to the hub's velocity, by columns.
INLINE void hub_ask(const Pools* p, const Hub* h, int what, LOCAL float* bench)
{
	HUB_EACH_COLUMN(c, h)
	{
		Real part[HUB_SUMS];
		for (int q = 0; q < HUB_SUMS; ++q)
			part[q] = splat(0.0f);
		HUB_EACH_OF(i, c, h) spoke_answer(p, h, i, what, part);
		for (int q = 0; q < HUB_SUMS; ++q)
			store(bench + q * HUB_COLUMNS, c, part[q]);
	}
}

// Returns whether all components of a velocity are within HUB_SPEED; 0 if one is NaN.
INLINE int hub_bears(const float v[3])
{
	int bears = 1;
	for (int q = 0; q < 3; ++q)
		bears = bears && v[q] >= -HUB_SPEED && v[q] <= HUB_SPEED;
	return bears;
}

// Computes the change of the hub's velocity from the sums of impulses on it. Returns whether it is within HUB_SPEED.
INLINE int hub_gains(const Hub* h, const float* sum, float gain[3])
{
	gain[0] = h->inv_mass * sum[0];
	gain[1] = h->inv_mass * sum[1];
	gain[2] = h->inv_inertia * sum[2];
	return hub_bears(gain);
}

// (m/s)^2: Returns twice the kinetic energy of the hub at a velocity, per kilogram of the hub.
INLINE float hub_energy(const Hub* h, const float v[3])
{
	return v[0] * v[0] + v[1] * v[1] + h->gyration * v[2] * v[2];
}

// Computes Newton's step d by L D L^T from (M + H) d = push - M (now - free). M: mass matrix of the hub without its
// spokes; push: impulse of the spokes; H: minus the derivative of `push` with respect to `now`. In exact arithmetic H
// lowers no pivot of M. Rounding could lower one, so each pivot is raised to that of M.
INLINE void hub_newton(const Hub* h, const float* sum, float d[3])
{
	float mass = h->mass, inertia = h->inertia;
	float xx = mass + sum[3], xy = sum[4], yy = mass + sum[5], xw = sum[6], yw = sum[7], ww = inertia + sum[8];
	float x = sum[0] - mass * (h->now[0] - h->free[0]), y = sum[1] - mass * (h->now[1] - h->free[1]),
	      w = sum[2] - inertia * (h->now[2] - h->free[2]);
	float yx = quotient(xy, xx), wx = quotient(xw, xx), second = yy - yx * xy;
	second = second > mass ? second : mass;
	float wy = quotient(yw - yx * xw, second), third = ww - wx * xw - wy * wy * second;
	third = third > inertia ? third : inertia;
	y = y - yx * x;
	w = w - wx * x - wy * y;
	// a hub that cannot rotate has no third equation
	d[2] = inertia > 0.0f ? quotient(w, third) : 0.0f;
	d[1] = quotient(y, second) - wy * d[2];
	d[0] = quotient(x, xx) - yx * d[1] - wx * d[2];
}

// Returns whether the rounds end: Newton's step d exceeds HUB_SPEED or is NaN, or it is small compared with the
// velocity and the velocity that gravity adds in a substep.
INLINE int hub_found(const Pools* p, const Hub* h, const float d[3])
{
	float x = p->step.h * gravity_x_of(p, h->body), y = p->step.h * gravity_y_of(p, h->body), most = p->step.max_speed;
	float fall[3] = {x < most && x > -most ? x : most, y < most && y > -most ? y : most, 0.0f};
	float most_energy = HUB_CLOSE * HUB_CLOSE * (hub_energy(h, h->now) + hub_energy(h, fall));
	return !hub_bears(d) || hub_energy(h, d) <= (most_energy > ABSORBS ? most_energy : ABSORBS);
}

// Applies the fraction of the responses that minimizes the energy, so no energy is added; after convergence it is 1. It
// is 0 if the responses would change the velocity by more than HUB_SPEED, or a sum is not finite.
INLINE void hub_give(const Pools* p, Hub* h, int what, const float* sum)
{
	float gain[3], part = 0.0f, down = -sum[9];
	if (hub_gains(h, sum, gain))
	{
		// products in this order, because squares of large impulses may not be finite
		float bend = sum[10] + gain[0] * sum[0] + gain[1] * sum[1] + gain[2] * sum[2];
		if (down >= ABSORBS && bend >= ABSORBS && bend <= MOST_FLOAT)
			part = down < bend ? quotient(down, bend) : 1.0f;
		if (part < ABSORBS) // impulses may be so large that a denormal fraction of them counts
			part = 0.0f;
		for (int q = 0; q < 3; ++q)
			h->now[q] = h->free[q] + part * gain[q];
	}
	else
		for (int q = 0; q < 3; ++q)
			h->now[q] = h->free[q];
	HUB_EACH_COLUMN(c, h)
	HUB_EACH_OF(i, c, h) spoke_give(p, h, i, what, part);
}

// Returns the fraction of the last step's impulses with which a hub starts. gain: velocity that all of these impulses
// would give the hub. The fraction is 1 unless gain exceeds START_SHARE of max_speed, as in a jam after bodies have
// left. In gain, rotation counts by its energy.
INLINE float hub_start(const Step* step, const Hub* h, const float gain[3])
{
	float square = hub_energy(h, gain), most = START_SHARE * step->max_speed;
	return square > most * most ? quotient(most, square_root(square)) : 1.0f;
}

// Solves a block: computes the impulses of one kind (`what`) of all spokes, and the velocity that these give the hub.
// The sums are reduced at one place in the code, because each further place costs an OpenCL compiler for CPUs minutes.
INLINE_MEET void hub_block(const Pools* p, Hub* h, int what, int warm, LOCAL float* bench)
{
	float sum[HUB_SUMS] = {0.0f}, d[3];
	for (int q = 0; q < 3; ++q)
		h->from[q] = h->free[q] = h->now[q];
	int found = 0;
	for (int round = -1; round <= (warm ? -1 : HUB_ROUNDS) && !found; ++round)
	{
		if (round < 0)
			hub_pose(p, h, what, warm, bench);
		else
			hub_ask(p, h, what, bench);
		int sums = round < 0 ? 3 : HUB_SUMS;
		hub_add_up(h, sums, bench, sum);
		if (round < 0)
		{
			float gain[3];
			int bears = hub_gains(h, sum, gain);
			float start = !bears ? 0.0f : warm ? hub_start(&p->step, h, gain) : 1.0f;
			if (warm && start < 1.0f)
				HUB_EACH_COLUMN(c, h)
			HUB_EACH_OF(i, c, h) spoke_scale(p, h, i, what, start);
			for (int q = 0; q < 3; ++q)
				h->now[q] = h->free[q] = bears ? h->free[q] + start * gain[q] : h->free[q];
		}
		else if (round < HUB_ROUNDS)
		{
			hub_newton(h, sum, d);
			found = hub_found(p, h, d);
			for (int q = 0; q < 3; ++q)
				h->now[q] = found ? h->now[q] : h->now[q] + d[q];
		}
	}
	if (!warm)
		hub_give(p, h, what, sum);
}

// Returns the kind of block number k of a pass, -1 after the last.
INLINE int hub_what(const Step* step, int pass, int k)
{
	// friction and rolling resistance come after the normal impulses, which limit them, as in pair_relax
	if (pass == PASS_WARM_START || pass == PASS_RELAX)
		return k == 0 ? HUB_NORMAL : k == 1 ? HUB_FRICTION : k == 2 && step->has_rolling ? HUB_ROLL : -1;
	return k > 0 ? -1 : pass == PASS_BIAS ? HUB_SOFT : HUB_BOUNCE;
}

// Runs a pass over the spokes of a hub, after spoke_begin stored their neighbors.
INLINE_MEET void hub_work(const Pools* p, Hub* h, int pass, LOCAL float* bench)
{
	for (int k = 0, what = 0; what >= 0; ++k)
	{
		what = hub_what(&p->step, pass, k);
		if (what >= 0)
			hub_block(p, h, what, pass == PASS_WARM_START, bench);
	}
	if (pass == PASS_RELAX && STEP_RARE(p->step))
		HUB_EACH_COLUMN(c, h)
	HUB_EACH_OF(i, c, h)
	pair_total(p, i, load(&contact_row(p, normal_impulse1, i), 0), load(&contact_row(p, normal_impulse2, i), 0));
}

// Returns hub number n at the start of a pass. row: BodyState of its body.
INLINE Hub hub_begin(const Pools* p, int n, const float row[8])
{
	Hub h;
	HubSpan span = hub_span_of(p, n);
	float parts = spoke_at(p, hub_parts, spoke_of(p, span.first));
	h.body = span.body;
	h.first = span.first;
	h.count = span.count;
	h.inv_mass = parts * row[3];
	h.inv_inertia = parts * row[7];
	h.mass = quotient(1.0f, h.inv_mass);
	h.inertia = h.inv_inertia > 0.0f ? quotient(1.0f, h.inv_inertia) : 0.0f;
	h.gyration = h.inv_mass * h.inertia;
	h.gyration = h.gyration < HUB_GYRATION ? h.gyration : HUB_GYRATION;
	h.most = quotient(1.0e38f, (float)span.count);
	for (int q = 0; q < 3; ++q)
		h.now[q] = row[q];
	h.whole.v = vec(splat(row[0]), splat(row[1]));
	h.whole.w = splat(row[2]);
	h.whole.inv_mass = splat(row[3]);
	h.whole.d = vec(splat(row[4]), splat(row[5]));
	h.whole.da = splat(row[6]);
	h.whole.inv_inertia = splat(row[7]);
	body_turn(&h.whole);
	return h;
}

// Writes the velocity of a neighbor that can move to the pool body, except if it is split: hub_merge writes it then.
INLINE void spoke_end(const Pools* p, const Hub* h, int i)
{
	int m = spoke_of(p, i);
	Real row[4] = {load(&spoke_at(p, vx, m), 0), load(&spoke_at(p, vy, m), 0), load(&spoke_at(p, w, m), 0),
	               load(&spoke_at(p, inv_mass, m), 0)};
	Int whole = load(&spoke_at(p, parts, m), 0) == splat(1.0f);
	scatter_rows4of8((GLOBAL float*)p->body, spoke_neighbor(p, h, i), row, whole & (row[3] > splat(0.0f)));
}

// Runs a pass over hub n with a work-group, on the pool body. hub_merge writes the velocity if the hub itself is split.
INLINE_MEET void hub_pass(const Pools* p, int n, int pass, LOCAL float* bench)
{
	float row[8];
	read_row8((GLOBAL float*)p->body, hub_span_of(p, n).body, row);
	Hub h = hub_begin(p, n, row);
	HUB_EACH_COLUMN(c, &h)
	HUB_EACH_OF(i, c, &h) spoke_begin(p, &h, i, body_gather(p, spoke_neighbor(p, &h, i)));
	hub_work(p, &h, pass, bench);
	HUB_EACH_COLUMN(c, &h)
	HUB_EACH_OF(i, c, &h) spoke_end(p, &h, i);
	if (group_lane() != 0)
		return;
	int m = spoke_of(p, h.first);
	spoke_at(p, hub_x, m) = h.now[0];
	spoke_at(p, hub_y, m) = h.now[1];
	spoke_at(p, hub_w, m) = h.now[2];
	if (spoke_at(p, hub_parts, m) == 1.0f)
	{
		p->body[h.body].vx = h.now[0];
		p->body[h.body].vy = h.now[1];
		p->body[h.body].w = h.now[2];
	}
}

// Item: a hub of one hub color; in a batch, any hub. argument: the pass and the hub color.
GROUP_KERNEL(hub)
{
	int turn = RUN_HIGH(p->argument), n = BATCHED(p) ? i : HUB_COLORS * i + turn;
	if (hub_color(p, n) == turn)
		hub_pass(p, n, RUN_LOW(p->argument), bench);
}

#endif
