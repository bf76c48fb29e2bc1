// SPDX-License-Identifier: MIT
// mover.c -- moves movers (characters), capsules that walk, slide, climb steps and ride on their ground, by queries.
#include "api/mover/mover.h"
#include "api/mover/mover_slide.h"
#include "api/mover/swept.h"
#include "api/query/query_check.h"
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include "world/world.h"

void scree_mover_def_default_sized(scree_mover_def* def, size_t size)
{
	scree_mover_def made = {.size = (uint32_t)size,
	                        .length = 0.6f,
	                        .radius = 0.3f,
	                        .up = {0.0f, 1.0f},
	                        .max_slope = 0.8726646f, // 50 degrees
	                        .step_height = 0.3f,
	                        .snap_distance = 0.3f,
	                        .skin = 0.01f,
	                        .kinds = SCREE_QUERY_STATIC | SCREE_QUERY_KINEMATIC | SCREE_QUERY_DYNAMIC,
	                        .category = ~(uint64_t)0,
	                        .mask = ~(uint64_t)0};
	write_result(def, size, &made, sizeof made);
}

static const scree_pose nowhere = {{0.0f, 0.0f}, {0.0f, 0.0f}}; // ground pose of a mover that stands on no body

static bool is_nowhere(scree_pose pose) { return pose.rotation.c == 0.0f && pose.rotation.s == 0.0f; }

static scree_status check_mover_def(ArgumentPlace at, const scree_mover_def* def)
{
	TRY(check_real(at, ".length", def->length, 0.0f, SCREE_MAX_COORDINATE));
	if (def->length > 0.0f && def->length < 2.0f * SMALLEST_SIZE)
		return refuse(SCREE_ERROR_INVALID, at, ".length", "is %s, must be 0 or at least %s", decimal(def->length).text,
		              decimal(2.0f * SMALLEST_SIZE).text);
	TRY(check_real(at, ".radius", def->radius, SMALLEST_SIZE, SCREE_MAX_COORDINATE));
	TRY(check_vec(at, ".up", def->up, 2.0f));
	float square = dot(def->up, def->up);
	if (!(square > 0.999f && square < 1.001f))
		return refuse(SCREE_ERROR_INVALID, at, ".up", "is (%s, %s), must be a unit vector", decimal(def->up.x).text,
		              decimal(def->up.y).text);
	TRY(check_real(at, ".max_slope", def->max_slope, 0.0f, 1.570796f));
	TRY(check_real(at, ".step_height", def->step_height, 0.0f, SCREE_MAX_COORDINATE));
	TRY(check_real(at, ".snap_distance", def->snap_distance, 0.0f, SCREE_MAX_COORDINATE));
	TRY(check_real(at, ".skin", def->skin, SMALLEST_SIZE, SCREE_MAX_COORDINATE));
	// bounds the sizes and the translations of the queries
	float sum = def->length + def->radius + def->step_height + def->snap_distance + 3.0f * def->skin;
	TRY(check_real(at, ": the sum of its lengths", sum, 0.0f, SCREE_MAX_COORDINATE));
	return check_query_kinds(at, def->kinds);
}

static scree_status check_movers(const scree_world* world, const char* function, const scree_mover* movers, int count)
{
	for (int k = 0; k < count; ++k)
	{
		ArgumentPlace at = {function, "movers", k};
		scree_pose pose = movers[k].ground_pose;
		TRY(check_vec(at, ".position", movers[k].position, SCREE_MAX_COORDINATE));
		TRY(check_vec(at, ".velocity", movers[k].velocity, SCREE_MAX_COORDINATE));
		if (!scree_body_is_null(movers[k].ignored))
			TRY(check_body_once(world, at, ".ignored", movers[k].ignored));
		if (!is_nowhere(pose))
			TRY(check_pose(at, ".ground_pose", &pose));
	}
	return SCREE_OK;
}

// Writes to poses[k] the pose of the body on which mover k stands, or the pose `nowhere` if it stands on no body.
static scree_status ground_poses(MoverCall* call, scree_pose* poses)
{
	int count = 0;
	for (int k = 0; k < call->count; ++k)
	{
		scree_collidable ground = call->motions[k].ground;
		bool valid = collidable_is_valid(call->world, ground);
		call->bodies[count] = valid ? owner_handle(call->world, (int)ground.index - 1) : SCREE_NULL_BODY;
		if (!scree_body_is_null(call->bodies[count]))
			call->of[count++] = k;
	}
	for (int k = 0; k < call->count; ++k)
		poses[k] = nowhere;
	if (count == 0)
		return SCREE_OK;
	TRY(api_bodies_get_poses(call->world, call->bodies, call->poses, count));
	for (int k = 0; k < count; ++k)
		poses[call->of[k]] = call->poses[k];
	return SCREE_OK;
}

// m: Returns the displacement of a point on a body that moves from pose `from` to pose `to`. point: before the motion.
static scree_vec ride(scree_pose from, scree_pose to, scree_vec point)
{
	scree_rot back = {from.rotation.c, -from.rotation.s};
	scree_vec arm = {point.x - from.position.x, point.y - from.position.y};
	scree_vec turned = rot_vec(rot_product(to.rotation, back), arm);
	return (scree_vec){(to.position.x - from.position.x) + (turned.x - arm.x),
	                   (to.position.y - from.position.y) + (turned.y - arm.y)};
}

// Returns the tangent speed of a collidable's surface, m/s, clockwise around the collidable; 0 if it no longer exists.
static float belt_speed(const scree_world* world, scree_collidable ground)
{
	scree_attribute attribute;
	scree_attribute_def def;
	if (!collidable_is_valid(world, ground) || scree_collidable_get_attribute(world, ground, &attribute) != SCREE_OK ||
	    api_attribute_get_def_sized(world, attribute, &def, sizeof def) != SCREE_OK)
		return 0.0f;
	return def.tangent_speed;
}

// Initializes the motion of a mover. now: current pose of the body on which the mover stands, or the pose `nowhere`.
static void begin(const MoverCall* call, const scree_mover* mover, scree_pose now, float dt, MoverMotion* w)
{
	scree_vec up = call->def->up;
	float rise = dot(mover->velocity, up);
	w->at = mover->position;
	w->velocity = mover->velocity;
	if (!is_nowhere(now) && !is_nowhere(mover->ground_pose))
	{
		scree_vec foot = add_scaled(w->at, -0.5f * call->def->length - call->def->radius, up);
		w->carried = ride(mover->ground_pose, now, foot);
	}
	w->carried = add_scaled(w->carried, dt * belt_speed(call->world, mover->ground),
	                        (scree_vec){mover->normal.y, -mover->normal.x});
	w->stood = collidable_is_valid(call->world, mover->ground) && rise <= 0.0f;
	// the vertical velocity of a mover on ground is left out, because mover_stand moves the mover down to the ground
	scree_vec velocity = w->stood ? add_scaled(mover->velocity, -rise, up) : mover->velocity;
	w->way = add_scaled((scree_vec){0.0f, 0.0f}, dt, velocity);
	w->rest = w->carried;
	w->ground = SCREE_NULL_COLLIDABLE;
	w->crushed = !scree_collidable_is_null(mover->wall) && mover->wall_normal.x == 0.0f && mover->wall_normal.y == 0.0f;
}

static void end(const MoverMotion* w, scree_pose ground, float dt, scree_mover* mover)
{
	mover->position = w->at;
	mover->velocity = w->velocity;
	mover->ground = w->ground;
	mover->normal = w->normal;
	mover->ground_pose = ground;
	mover->ground_velocity = dt > 0.0f ? (scree_vec){w->carried.x / dt, w->carried.y / dt} : (scree_vec){0.0f, 0.0f};
	mover->wall = w->wall;
	mover->wall_normal = w->wall_normal;
}

static scree_status move(MoverCall* call, scree_mover* movers, scree_pose* poses, float dt)
{
	for (int k = 0; k < call->count; ++k)
		call->motions[k] = (MoverMotion){.ground = movers[k].ground};
	TRY(ground_poses(call, poses));
	for (int k = 0; k < call->count; ++k)
		begin(call, movers + k, poses[k], dt, call->motions + k);
	TRY(mover_is_crushed(call));
	TRY(mover_swept(call, dt));
	TRY(mover_slide(call)); // moves the movers with their ground; afterwards movers may overlap surfaces
	TRY(mover_recover(call));
	for (int k = 0; k < call->count; ++k)
	{
		call->motions[k].rest = call->motions[k].way;
		call->motions[k].ground = SCREE_NULL_COLLIDABLE;
	}
	TRY(mover_slide(call));
	TRY(mover_stand(call));
	TRY(ground_poses(call, poses));
	for (int k = 0; k < call->count; ++k)
		end(call->motions + k, poses[k], dt, movers + k);
	return SCREE_OK;
}

scree_status mover_check(scree_world* world, const char* function, const scree_mover* movers, int count, float dt,
                         const scree_mover_def* def, scree_mover_def* used)
{
	ArgumentPlace at = {function, "def", ALONE};
	scree_mover_def local, standard = scree_mover_def_default();
	TRY(world_check(world, function));
	TRY(check_batch(function, "movers", movers, count));
	def = def ? def : &standard;
	TRY(check_definition(at, def, 0, &mover_definition));
	*used = *(const scree_mover_def*)definition_at(def, 0, &mover_definition, &local);
	TRY(check_mover_def(at, used));
	TRY(check_movers(world, function, movers, count));
	return check_real((ArgumentPlace){function, "dt", ALONE}, "", dt, 0.0f, 1.0f);
}

scree_query_def mover_query(const scree_mover_def* def)
{
	scree_query_def seen = scree_query_def_default();
	seen.kinds = def->kinds;
	seen.category = def->category;
	seen.mask = def->mask;
	seen.one_way = true;
	return seen;
}

scree_status mover_shape(const scree_mover_def* def, scree_shape* shape)
{
	scree_vec half = add_scaled((scree_vec){0.0f, 0.0f}, 0.5f * def->length, def->up);
	return def->length > 0.0f ? scree_shape_make_capsule((scree_vec){-half.x, -half.y}, half, def->radius, shape)
	                          : scree_shape_make_circle((scree_vec){0.0f, 0.0f}, def->radius, shape);
}

float mover_steepest(const scree_mover_def* def) { return scree_rot_make(def->max_slope).c - 1e-4f; }

scree_status api_movers_move(scree_world* world, const scree_mover_def* def, scree_mover* movers, int count, float dt)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_movers_move";
	scree_mover_def used;
	TRY(mover_check(world, function, movers, count, dt, def, &used));
	if (count == 0)
		return SCREE_OK;
	scree_query_def seen = mover_query(&used);
	seen.skip_inside = true;
	MoverCall call = {.world = world,
	                  .def = &used,
	                  .seen = seen,
	                  .along = {used.up.y, -used.up.x},
	                  .steepest = mover_steepest(&used),
	                  .count = count,
	                  .movers = movers};
	TRY(mover_shape(&used, &call.shape));
	size_t n = (size_t)count, each = sizeof(MoverMotion) + sizeof(scree_probe) + sizeof(scree_ray) +
	                                 2 * sizeof(scree_query_result) + 2 * sizeof(scree_pose) + sizeof(scree_body) +
	                                 sizeof(int);
	call.motions = scree_allocate(each * n);
	if (!call.motions)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d movers", function, count);
	call.probes = (scree_probe*)(void*)(call.motions + n);
	call.rays = (scree_ray*)(void*)(call.probes + n);
	call.found = (scree_query_result*)(void*)(call.rays + n);
	scree_pose* poses = (scree_pose*)(void*)(call.found + 2 * n);
	call.poses = poses + n;
	call.bodies = (scree_body*)(void*)(call.poses + n);
	call.of = (int*)(void*)(call.bodies + n);
	scree_status status = move(&call, movers, poses, dt);
	scree_release(call.motions);
	return status;
}
