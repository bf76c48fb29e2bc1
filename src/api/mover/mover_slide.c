// SPDX-License-Identifier: MIT
// mover_slide.c -- computes the parts of the motion of movers, each by some rounds of queries for all movers of a call.
#include "api/mover/mover_slide.h"
#include "world/check.h"
#include "world/record/api_calls.h"
#include <math.h>

#define RECOVER_ROUNDS 8
#define SLIDE_ROUNDS   5
#define TOUCH          1e-4f // m: tolerance of the distance between mover and surface, which should equal the skin
#define BESIDE         0.02f // m: a ray that searches for the top of a step begins this far beside and above its corner

static void ask(MoverCall* call, int k, scree_vec from, scree_vec translation)
{
	call->probes[call->asked] = (scree_probe){.pose = {from, {1.0f, 0.0f}}, translation, call->movers[k].ignored};
	call->of[call->asked++] = k;
}

// m: Returns the length by which probe k may move. If it hits a surface, the motion ends with the skin between them.
static float free_length(const MoverCall* call, int k)
{
	scree_vec way = call->probes[k].translation;
	const scree_query_result* found = call->found + k;
	float length = sqrtf(dot(way, way));
	if (!found->hit)
		return length;
	float into = -dot(way, found->normal) / length;
	float s = found->fraction * length - call->def->skin / (into > 1e-6f ? into : 1e-6f);
	return s > 0.0f ? s : 0.0f;
}

// Casts each probe with the mover's shape and with a larger shape, and keeps the result that allows less motion. A cast
// ignores surfaces that the shape overlaps at the start, so the larger shape is enlarged by a little less than the
// skin.
static scree_status cast(MoverCall* call)
{
	scree_query_result* wide = call->found + call->count;
	scree_shape shape = call->shape;
	float skin = call->def->skin > 4.0f * TOUCH ? call->def->skin - 2.0f * TOUCH : 0.5f * call->def->skin;
	shape.radius += skin;
	TRY(api_world_cast_shapes(call->world, &call->seen, &call->shape, call->probes, call->asked, call->found));
	TRY(api_world_cast_shapes(call->world, &call->seen, &shape, call->probes, call->asked, wide));
	for (int k = 0; k < call->asked; ++k)
	{
		scree_vec way = call->probes[k].translation;
		float length = sqrtf(dot(way, way)), into = -dot(way, wide[k].normal) / length;
		if (!wide[k].hit || into <= 1e-6f || wide[k].fraction * length >= free_length(call, k))
			continue;
		call->found[k] = wide[k];
		call->found[k].fraction += skin / (into * length);
	}
	return SCREE_OK;
}

scree_vec mover_within(scree_vec at)
{
	return (scree_vec){fminf(fmaxf(at.x, -SCREE_MAX_COORDINATE), SCREE_MAX_COORDINATE),
	                   fminf(fmaxf(at.y, -SCREE_MAX_COORDINATE), SCREE_MAX_COORDINATE)};
}

static scree_vec free_end(const MoverCall* call, int k)
{
	scree_vec way = call->probes[k].translation;
	float length = sqrtf(dot(way, way));
	return length > 0.0f ? mover_within(add_scaled(call->probes[k].pose.position, free_length(call, k) / length, way))
	                     : call->probes[k].pose.position;
}

static bool is_ground(const MoverCall* call, scree_vec normal) { return dot(normal, call->def->up) >= call->steepest; }

static scree_vec clip(scree_vec v, scree_vec normal)
{
	float against = dot(v, normal);
	return against < 0.0f ? add_scaled(v, -against, normal) : v;
}

// Returns velocity or motion v of a mover without its part into a surface. If the surface is too steep to stand on, it
// never makes the mover rise, or rise faster.
static scree_vec deflect(const MoverCall* call, scree_vec v, scree_vec normal)
{
	scree_vec up = call->def->up, free = clip(v, normal);
	float rises = dot(v, up), steep = dot(normal, up);
	scree_vec level = add_scaled(normal, -steep, up);
	float length = sqrtf(dot(level, level));
	if (steep <= 0.0f || length == 0.0f || is_ground(call, normal) || dot(free, up) <= (rises > 0.0f ? rises : 0.0f))
		return free;
	return clip(v, (scree_vec){level.x / length, level.y / length});
}

// Stops a mover at a surface: stores it as ground or wall, and removes the parts of remaining motion and velocity that
// point into the surface.
static void meet(const MoverCall* call, MoverMotion* w, scree_collidable collidable, scree_vec normal)
{
	scree_vec up = call->def->up;
	if (is_ground(call, normal))
	{
		// ground removes only falling velocity: a walkable slope must not turn a fall into a motion down the slope
		w->velocity = clip(w->velocity, up);
		w->rest = clip(w->rest, up);
		if (dot(w->velocity, up) <= 0.0f)
		{
			w->ground = collidable;
			w->normal = normal;
		}
	}
	else
	{
		w->wall = collidable;
		w->wall_normal = normal;
		w->kept = w->velocity;
		w->push = w->stood ? w->rest : (scree_vec){0.0f, 0.0f};
		// a mover that stood keeps its falling velocity at a wall; the rest of its velocity is deflected
		float fall = w->stood && dot(w->velocity, up) < 0.0f ? dot(w->velocity, up) : 0.0f;
		w->velocity = add_scaled(deflect(call, add_scaled(w->velocity, -fall, up), normal), fall, up);
	}
	w->rest = deflect(call, w->rest, normal);
	if (dot(w->rest, w->last) < -1e-6f)
		w->rest = (scree_vec){0.0f, 0.0f}; // the mover is wedged between two surfaces
	w->last = normal;
}

// A crushed mover is not pushed out: a surface beyond the middle of the mover would push it to the wrong side.
void mover_crush(const MoverCall* call, int k, scree_collidable by)
{
	call->motions[k] = (MoverMotion){.at = call->movers[k].position, .wall = by, .crushed = true};
}

scree_status mover_is_crushed(MoverCall* call)
{
	call->asked = 0;
	for (int k = 0; k < call->count; ++k)
		if (call->motions[k].crushed)
			ask(call, k, call->motions[k].at, (scree_vec){0});
	if (call->asked == 0)
		return SCREE_OK;
	TRY(api_world_find_nearest(call->world, &call->seen, &call->shape, call->probes, call->asked, call->def->skin,
	                           call->found));
	for (int k = 0; k < call->asked; ++k)
	{
		const scree_query_result* found = call->found + k;
		if (found->hit && found->fraction < -TOUCH)
			mover_crush(call, call->of[k], found->collidable);
		else
			call->motions[call->of[k]].crushed = false;
	}
	return SCREE_OK;
}

scree_status mover_recover(MoverCall* call)
{
	for (int round = 0; round < RECOVER_ROUNDS; ++round)
	{
		// the first round tests all movers, a later round only the movers that the previous round moved
		int asked = round == 0 ? call->count : call->asked;
		call->asked = 0;
		for (int k = 0; k < asked; ++k)
		{
			int i = round == 0 ? k : call->of[k];
			if (!call->motions[i].crushed)
				ask(call, i, call->motions[i].at, (scree_vec){0});
		}
		if (call->asked == 0)
			break;
		TRY(api_world_find_nearest(call->world, &call->seen, &call->shape, call->probes, call->asked, call->def->skin,
		                           call->found));
		int moved = 0;
		for (int k = 0; k < call->asked; ++k)
		{
			const scree_query_result* found = call->found + k;
			float lacks = found->hit ? call->def->skin - found->fraction : 0.0f;
			if (lacks <= TOUCH)
				continue;
			MoverMotion* w = call->motions + call->of[k];
			if (round == RECOVER_ROUNDS - 1 && found->fraction < -TOUCH)
			{
				mover_crush(call, call->of[k], found->collidable);
				continue;
			}
			w->at = mover_within(add_scaled(w->at, lacks, found->normal));
			meet(call, w, found->collidable, found->normal);
			w->ground = SCREE_NULL_COLLIDABLE;
			w->push = (scree_vec){0.0f, 0.0f};
			call->of[moved++] = call->of[k];
		}
		call->asked = moved;
		if (moved == 0)
			break;
	}
	for (int k = 0; k < call->count; ++k)
		call->motions[k].last = (scree_vec){0.0f, 0.0f};
	return SCREE_OK;
}

// Keeps found[].hit only if the mover can stand on the surface that its probe hit. A mover can stand on ground. It can
// also stand on a corner, if there is ground beside the corner and the round end of the capsule rises by at most
// step_height to get over the corner.
static scree_status find_ground(MoverCall* call)
{
	const scree_mover_def* def = call->def;
	int rays = 0;
	for (int k = 0; k < call->asked; ++k)
	{
		scree_query_result* found = call->found + k;
		float rises = dot(found->normal, def->up);
		if (!found->hit || is_ground(call, found->normal))
			continue;
		found->hit = rises > 0.0f && (1.0f - rises) * def->radius <= def->step_height;
		if (!found->hit)
			continue;
		float out = dot(found->normal, call->along) > 0.0f ? -BESIDE : BESIDE;
		scree_vec from = mover_within(add_scaled(add_scaled(found->point, out, call->along), BESIDE, def->up));
		call->rays[rays++] = (scree_ray){.origin = from,
		                                 .translation = add_scaled((scree_vec){0}, -3.0f * BESIDE, def->up),
		                                 .ignored = call->movers[call->of[k]].ignored};
	}
	if (rays == 0)
		return SCREE_OK;
	scree_query_result* beside = call->found + call->count;
	TRY(api_world_cast_rays(call->world, &call->seen, call->rays, rays, beside));
	for (int k = 0, ray = 0; k < call->asked; ++k)
		if (call->found[k].hit && !is_ground(call, call->found[k].normal))
		{
			call->found[k].hit = beside[ray].hit && is_ground(call, beside[ray].normal);
			++ray;
		}
	return SCREE_OK;
}

// Moves movers that a wall stopped onto a step: up, forward and down. A mover stays where it is if there is no ground,
// the step is too high, or the way forward is blocked.
static scree_status climb(MoverCall* call)
{
	const scree_mover_def* def = call->def;
	scree_vec up = def->up;
	call->asked = 0;
	for (int k = 0; k < call->count; ++k)
		if (dot(call->motions[k].push, call->motions[k].push) > 0.0f)
			ask(call, k, call->motions[k].at, add_scaled((scree_vec){0}, def->step_height + def->skin, up));
	if (call->asked == 0)
		return SCREE_OK;
	TRY(cast(call));
	for (int k = 0; k < call->asked; ++k)
	{
		const MoverMotion* w = call->motions + call->of[k];
		call->probes[k].pose.position = free_end(call, k);
		call->probes[k].translation = add_scaled(w->push, -dot(w->push, up), up);
	}
	TRY(cast(call));
	for (int k = 0; k < call->asked; ++k)
	{
		call->probes[k].pose.position = free_end(call, k);
		call->probes[k].translation = add_scaled((scree_vec){0}, -(def->step_height + 3.0f * def->skin), up);
	}
	TRY(cast(call));
	TRY(find_ground(call));
	for (int k = 0; k < call->asked; ++k)
	{
		MoverMotion* w = call->motions + call->of[k];
		scree_vec end = free_end(call, k), step = {end.x - w->at.x, end.y - w->at.y};
		scree_vec top = {call->found[k].point.x - w->at.x, call->found[k].point.y - w->at.y};
		float rises = dot(top, up) + 0.5f * def->length + def->radius + def->skin;
		if (call->found[k].hit && rises <= def->step_height + TOUCH &&
		    dot(step, w->push) > 0.5f * TOUCH * sqrtf(dot(w->push, w->push)))
		{
			w->at = end;
			w->ground = call->found[k].collidable;
			w->normal = call->found[k].normal;
			w->velocity = clip(w->kept, up);
			w->rest = (scree_vec){0.0f, 0.0f};
			w->wall = SCREE_NULL_COLLIDABLE;
			w->wall_normal = (scree_vec){0.0f, 0.0f};
		}
		w->push = (scree_vec){0.0f, 0.0f};
	}
	return SCREE_OK;
}

scree_status mover_slide(MoverCall* call)
{
	for (int round = 0; round < SLIDE_ROUNDS; ++round)
	{
		call->asked = 0;
		for (int k = 0; k < call->count; ++k)
			if (dot(call->motions[k].rest, call->motions[k].rest) > 0.0f)
				ask(call, k, call->motions[k].at, call->motions[k].rest);
		if (call->asked == 0)
			break;
		TRY(cast(call));
		for (int k = 0; k < call->asked; ++k)
		{
			MoverMotion* w = call->motions + call->of[k];
			scree_vec end = free_end(call, k);
			w->rest = call->found[k].hit ? (scree_vec){w->at.x + w->rest.x - end.x, w->at.y + w->rest.y - end.y}
			                             : (scree_vec){0.0f, 0.0f};
			w->at = end;
			if (call->found[k].hit)
				meet(call, w, call->found[k].collidable, call->found[k].normal);
		}
		if (call->def->step_height > 0.0f)
			TRY(climb(call));
	}
	return SCREE_OK;
}

scree_status mover_stand(MoverCall* call)
{
	const scree_mover_def* def = call->def;
	call->asked = 0;
	for (int k = 0; k < call->count; ++k)
	{
		const MoverMotion* w = call->motions + k;
		float reach = 2.0f * def->skin + (w->stood ? def->snap_distance : 0.0f);
		if (!w->crushed && dot(w->velocity, def->up) <= 0.0f && scree_collidable_is_null(w->ground))
			ask(call, k, w->at, add_scaled((scree_vec){0}, -reach, def->up));
	}
	if (call->asked == 0)
		return SCREE_OK;
	TRY(cast(call));
	TRY(find_ground(call));
	for (int k = 0; k < call->asked; ++k)
	{
		if (!call->found[k].hit)
			continue;
		MoverMotion* w = call->motions + call->of[k];
		w->at = free_end(call, k);
		w->ground = call->found[k].collidable;
		w->normal = call->found[k].normal;
		w->velocity = clip(w->velocity, def->up);
	}
	return SCREE_OK;
}
