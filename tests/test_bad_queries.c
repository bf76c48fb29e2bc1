// SPDX-License-Identifier: MIT
// test_bad_queries.c -- checks that every query refuses bad arguments with a message that names argument and value, and
// changes nothing.
#include "support/bad_input.h"
#include <float.h>
#include <math.h>
#include <string.h>

static void rays(void** state)
{
	(void)state;
	scree_ray list[2] = {{.translation = {1, 0}}, {.translation = {1, 0}}};
	scree_query_result found[2];
	scree_query_results all;
	scree_query_def def = scree_query_def_default();
	INVALID(scree_world_cast_rays, (NULL, NULL, list, 2, found), "world is null");
	INVALID(scree_world_cast_rays, (world, NULL, NULL, 2, found), "rays is null");
	INVALID(scree_world_cast_rays, (world, NULL, list, 2, NULL), "found is null");
	INVALID(scree_world_cast_rays, (world, NULL, list, -1, found), "count is -1");
	OK(scree_world_cast_rays(world, NULL, NULL, 0, NULL));
#define RAY(status, change, sentence)                                                          \
	list[1] = list[0];                                                                         \
	list[1].change;                                                                            \
	REFUSED(scree_world_cast_rays, (world, NULL, list, 2, found), status, "rays[1]" sentence); \
	REFUSED(scree_world_list_rays, (world, NULL, list, 2, &all), status, "rays[1]" sentence)
	RAY(SCREE_ERROR_INVALID, origin.x = NAN, ".origin.x is nan");
	RAY(SCREE_ERROR_INVALID, translation.y = INFINITY, ".translation.y is inf");
	RAY(SCREE_ERROR_INVALID, translation.y = 3e5f, ".translation.y is 300000");
	RAY(SCREE_ERROR_INVALID, radius = -1, ".radius is -1");
	RAY(SCREE_ERROR_INVALID, reserved = 7, ".reserved is 7, must be 0");
	RAY(SCREE_ERROR_STALE, ignored = ((scree_body){900, 1}),
	    ".ignored (index 900, generation 1) was destroyed, or belongs");
	RAY(SCREE_ERROR_STALE, ignored = ((scree_body){stale.index, 99}), ".ignored (index 4, generation 99)");
#undef RAY
	def.size = 0;
	INVALID(scree_world_cast_rays, (world, &def, list, 1, found),
	        "def.size is 0: the definition was not made by scree_query_def_default");
	def = scree_query_def_default();
	def.kinds = 64;
	INVALID(scree_world_cast_rays, (world, &def, list, 1, found), "def.kinds is 64, has bits other than SCREE_QUERY_*");
	def = scree_query_def_default();
	def.any = true;
	INVALID(scree_world_list_rays, (world, &def, list, 1, &all), "def.any is true, but a list has all");
	INVALID(scree_world_list_rays, (world, NULL, list, 1, NULL), "list is null");
	INVALID(scree_world_cast_ray, (world, (scree_vec){0, NAN}, (scree_vec){1, 0}, found), "origin.y is nan");
	INVALID(scree_world_cast_ray, (world, (scree_vec){0, 0}, (scree_vec){3e5f, 0}, found), "translation.x is 300000");
}

static void shapes(void** state)
{
	(void)state;
	scree_shape shape = box_shape(0.5f, 0.5f), bad = shape;
	scree_probe probes[2] = {{.pose = good_pose}, {.pose = good_pose}};
	scree_query_result found[2];
	scree_query_results all;
	scree_query_def def = scree_query_def_default();
	bad.vertices[2].x = NAN;
	INVALID(scree_world_cast_shapes, (world, NULL, &bad, probes, 2, found), "shape.vertices[2].x is nan");
	bad.count = 9;
	INVALID(scree_world_cast_shapes, (world, NULL, &bad, probes, 2, found), "shape.count is 9");
	bad = (scree_shape){0};
	INVALID(scree_world_cast_shapes, (world, NULL, &bad, probes, 2, found), "shape.count is 0");
#define PROBE(status, change, sentence)                                                                      \
	probes[1] = probes[0];                                                                                   \
	probes[1].change;                                                                                        \
	REFUSED(scree_world_cast_shapes, (world, NULL, &shape, probes, 2, found), status, "probes[1]" sentence); \
	REFUSED(scree_world_list_shapes, (world, NULL, &shape, probes, 2, &all), status, "probes[1]" sentence);  \
	REFUSED(scree_world_find_nearest, (world, NULL, &shape, probes, 2, 1, found), status, "probes[1]" sentence)
	PROBE(SCREE_ERROR_INVALID, pose.position.x = NAN, ".pose.position.x is nan");
	PROBE(SCREE_ERROR_INVALID, pose.rotation.c = -2, ".pose.rotation is (-2, 1)");
	PROBE(SCREE_ERROR_INVALID, translation.x = NAN, ".translation.x is nan");
	PROBE(SCREE_ERROR_STALE, ignored = ((scree_body){900, 1}),
	      ".ignored (index 900, generation 1) was destroyed, or belongs");
	PROBE(SCREE_ERROR_STALE, ignored = ((scree_body){stale.index, 99}), ".ignored (index 4, generation 99)");
#undef PROBE
	probes[1] = probes[0];
	probes[1].translation.x = 1;
	INVALID(scree_world_find_nearest, (world, NULL, &shape, probes, 2, 1, found), "probes[1].translation.x is 1");
	scree_pose lost = good_pose;
	lost.position.y = INFINITY;
	INVALID(scree_world_cast_shape, (world, &shape, lost, (scree_vec){1, 0}, found), "pose.position.y is inf");
	INVALID(scree_world_cast_shape, (world, &shape, good_pose, (scree_vec){0, NAN}, found), "translation.y is nan");
	probes[1] = probes[0];
	INVALID(scree_world_find_nearest, (world, NULL, &shape, probes, 2, NAN, found), "distance is nan");
	INVALID(scree_world_find_nearest, (world, NULL, &shape, probes, 2, -1, found), "distance is -1");
	def.any = true;
	INVALID(scree_world_find_nearest, (world, &def, &shape, probes, 2, 1, found),
	        "def.any is true, but the nearest cannot be any");
	scree_box flat = {{1, 1}, {1, 2}};
	assert_refused(scree_world_overlap_box(world, flat, &all), SCREE_ERROR_INVALID,
	               "scree_world_overlap_box: ", "box from (1, 1) to (1, 2) is not 0.002 m wide and high");
	flat.upper.x = 1.001f;
	assert_refused(scree_world_overlap_box(world, flat, &all), SCREE_ERROR_INVALID,
	               "scree_world_overlap_box: ", "box from (1, 1) to (1.001, 2) is not");
	flat.lower.y = NAN;
	assert_refused(scree_world_overlap_box(world, flat, &all), SCREE_ERROR_INVALID,
	               "scree_world_overlap_box: ", "box.lower.y is nan");
}

static void sensors(void** state)
{
	(void)state;
	uint32_t bits;
	int count;
	scree_visit visit;
	INVALID(scree_collidable_set_sensor, (world, part, 8), "sensor is 8, must be bits of SCREE_SENSOR_MOVING");
	STALE(scree_collidable_set_sensor, (world, stale_part, 1), "collidable (index 4");
	STALE(scree_collidable_get_sensor, (world, stale_part, &bits), "collidable (index 4");
	INVALID(scree_collidable_get_sensor, (world, part, NULL), "sensor is null");
	INVALID(scree_collidable_get_visits, (world, part, &visit, 1, &count), "is no sensor");
	STALE(scree_collidable_get_visits, (world, stale_part, &visit, 1, &count), "sensor (index 4");
	scree_collidable pair[2] = {part, stale_part};
	uint32_t two[2] = {1, 1};
	STALE(scree_collidables_set_reports, (world, pair, two, 2), "collidables[1] (index 4");
	pair[1] = part;
	two[1] = 8;
	INVALID(scree_collidables_set_reports, (world, pair, two, 2), "reports[1] is 8");
	INVALID(scree_world_get_moved_bodies, (world, NULL), "list is null");
	OK(scree_collidable_get_sensor(world, part, &bits));
	assert_true(bits == 0);
}

static void blasts(void** state)
{
	(void)state;
	scree_blast_def def = scree_blast_def_default();
	int count;
	INVALID(scree_world_blast, (world, NULL, &count), "def is null");
#define DEF(change, sentence)        \
	def = scree_blast_def_default(); \
	def.change;                      \
	INVALID(scree_world_blast, (world, &def, &count), "def" sentence)
	DEF(size = 0, ".size is 0: the definition was not made by scree_blast_def_default");
	DEF(position.x = NAN, ".position.x is nan");
	DEF(radius = -1, ".radius is -1");
	DEF(falloff = INFINITY, ".falloff is inf");
	DEF(impulse = NAN, ".impulse is nan");
#undef DEF
	def = scree_blast_def_default();
	def.radius = 1000;
	// seen from this point, a box is as wide as its diagonal, which is longer than its sides
	def.position = (scree_vec){-3, -2};
	def.impulse = FLT_MAX;
	INVALID(scree_world_blast, (world, &def, &count), "def.impulse is 3.4028235e+38: an impulse on collidable");
}

static void shapes_without_a_world(void** state)
{
	(void)state;
	scree_shape shape = box_shape(0.5f, 0.5f);
	scree_distance distance;
	scree_query_result found;
	bool contains;
	scree_pose bad = {{1, NAN}, {1, 0}};
	INVALID(scree_shapes_get_distance, (&shape, good_pose, &shape, good_pose, NULL), "distance is null");
	INVALID(scree_shapes_get_distance, (&shape, good_pose, &shape, bad, &distance), "pose_b.position.y is nan");
	INVALID(scree_shapes_cast, (&shape, good_pose, &shape, good_pose, (scree_vec){NAN, 0}, &found),
	        "translation.x is nan");
	INVALID(scree_shape_cast_ray, (&shape, good_pose, (scree_vec){NAN, 0}, (scree_vec){1, 0}, &found),
	        "origin.x is nan");
	INVALID(scree_shape_contains, (&shape, good_pose, (scree_vec){NAN, 0}, &contains), "point.x is nan");
	INVALID(scree_shape_contains, (NULL, good_pose, (scree_vec){1, 0}, &contains), "shape is null");
	INVALID(scree_shapes_get_impact, (&shape, good_pose, bad, &shape, good_pose, good_pose, &found),
	        "to_a.position.y is nan");
}

static void movers(void** state)
{
	(void)state;
	scree_mover list[2] = {{.position = {1, 2}}, {.position = {3, 4}}};
	scree_mover_def def = scree_mover_def_default();
	INVALID(scree_movers_move, (NULL, NULL, list, 2, 0.1f), "world is null");
	INVALID(scree_movers_move, (world, NULL, NULL, 2, 0.1f), "movers is null");
	INVALID(scree_movers_move, (world, NULL, list, -1, 0.1f), "count is -1");
	INVALID(scree_movers_move, (world, NULL, list, 2, NAN), "dt is nan");
	INVALID(scree_movers_move, (world, NULL, list, 2, -0.1f), "dt is -0.1");
	INVALID(scree_movers_move, (world, NULL, list, 2, 2), "dt is 2");
	OK(scree_movers_move(world, NULL, NULL, 0, 0.1f));
#define DEF(change, sentence)        \
	def = scree_mover_def_default(); \
	def.change;                      \
	INVALID(scree_movers_move, (world, &def, list, 2, 0.1f), "def" sentence)
	DEF(size = 0, ".size is 0: the definition was not made by scree_mover_def_default");
	DEF(length = -1, ".length is -1");
	DEF(length = 0.001f, ".length is 0.001, must be 0 or at least 0.002");
	DEF(radius = 0, ".radius is 0");
	DEF(up = ((scree_vec){1, 1}), ".up is (1, 1), must be a unit vector");
	DEF(up.y = NAN, ".up.y is nan");
	DEF(max_slope = 2, ".max_slope is 2");
	DEF(step_height = -1, ".step_height is -1");
	DEF(snap_distance = INFINITY, ".snap_distance is inf");
	DEF(skin = 0, ".skin is 0");
	DEF(radius = SCREE_MAX_COORDINATE, ": the sum of its lengths is 100001");
	DEF(kinds = 64, ".kinds is 64, has bits other than SCREE_QUERY_*");
#undef DEF
#define MOVER(status, change, sentence) \
	list[1] = list[0];                  \
	list[1].change;                     \
	REFUSED(scree_movers_move, (world, NULL, list, 2, 0.1f), status, "movers[1]" sentence)
	MOVER(SCREE_ERROR_INVALID, position.y = NAN, ".position.y is nan");
	MOVER(SCREE_ERROR_INVALID, velocity.x = 1e9f, ".velocity.x is 1e+09");
	MOVER(SCREE_ERROR_INVALID, ground_pose.rotation.c = 3, ".ground_pose.rotation is (3, 0)");
	MOVER(SCREE_ERROR_STALE, ignored = ((scree_body){900, 1}),
	      ".ignored (index 900, generation 1) was destroyed, or belongs");
	MOVER(SCREE_ERROR_STALE, ignored = ((scree_body){stale.index, 99}), ".ignored (index 4, generation 99)");
#undef MOVER
}

static void mover_bodies(void** state)
{
	(void)state;
	scree_body followers[2] = {body, second};
	for (int k = 0; k < 2; ++k)
		OK(scree_body_set_type(world, followers[k], SCREE_BODY_KINEMATIC));
	OK(scree_world_get_hash(world, &before));
	scree_mover list[2] = {{.position = {1, 2}}, {.position = {3, 4}}}, kept[2];
	scree_mover_def def = scree_mover_def_default();
	memcpy(kept, list, sizeof list);
	INVALID(scree_movers_move_bodies, (NULL, NULL, list, followers, 2, 1, 0.1f), "world is null");
	INVALID(scree_movers_move_bodies, (world, NULL, NULL, followers, 2, 1, 0.1f), "movers is null");
	INVALID(scree_movers_move_bodies, (world, NULL, list, NULL, 2, 1, 0.1f), "bodies is null");
	INVALID(scree_movers_move_bodies, (world, NULL, list, followers, -1, 1, 0.1f), "count is -1");
	INVALID(scree_movers_move_bodies, (world, NULL, list, followers, 2, -1, 0.1f), "push_force is -1");
	INVALID(scree_movers_move_bodies, (world, NULL, list, followers, 2, NAN, 0.1f), "push_force is nan");
	INVALID(scree_movers_move_bodies, (world, NULL, list, followers, 2, INFINITY, 0.1f), "push_force is inf");
	INVALID(scree_movers_move_bodies, (world, NULL, list, followers, 2, 1, NAN), "dt is nan");
	INVALID(scree_movers_move_bodies, (world, NULL, list, followers, 2, 1, 2), "dt is 2");
	def.radius = NAN;
	INVALID(scree_movers_move_bodies, (world, &def, list, followers, 2, 1, 0.1f), "def.radius is nan");
#define PAIR(status, handle, sentence)                                                                          \
	REFUSED(scree_movers_move_bodies, (world, NULL, list, ((scree_body[2]){followers[0], handle}), 2, 1, 0.1f), \
	        status, "bodies[1]" sentence)
	PAIR(SCREE_ERROR_INVALID, followers[0], " (index");
	PAIR(SCREE_ERROR_INVALID, fixed, " is static: only a kinematic body follows a mover");
	PAIR(SCREE_ERROR_STALE, stale, "");
	PAIR(SCREE_ERROR_STALE, ((scree_body){900, 1}), "");
#undef PAIR
	list[1].ignored = kept[1].ignored = fixed;
	INVALID(scree_movers_move_bodies, (world, NULL, list, followers, 2, 1, 0.1f),
	        "movers[1].ignored is another body than bodies[1]");
	assert_memory_equal(list, kept, sizeof list);
	OK(scree_movers_move_bodies(world, NULL, NULL, NULL, 0, 1, 0.1f));
	// a definition that excludes the followers allows other ignored bodies
	def = scree_mover_def_default();
	def.kinds &= ~SCREE_QUERY_KINEMATIC;
	OK(scree_movers_move_bodies(world, &def, list, followers, 2, 1, 0.1f));
	assert_true(scree_body_equals(list[1].ignored, fixed));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(rays),         cmocka_unit_test(shapes), cmocka_unit_test(shapes_without_a_world),
	    cmocka_unit_test(sensors),      cmocka_unit_test(blasts), cmocka_unit_test(movers),
	    cmocka_unit_test(mover_bodies),
	};
	return cmocka_run_group_tests(tests, set_up_bad_input, tear_down_bad_input);
}
