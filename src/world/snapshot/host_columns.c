// SPDX-License-Identifier: MIT
// host_columns.c -- lists the columns of the structs on the host that a snapshot contains.
#include "world/snapshot/host_columns.h"
#include "world/world.h"

// Columns of the members of a world and of its definition. The device, its threads and its lanes are not those of a
// snapshot.
static const Column world_columns[] = {
    COLUMN(scree_world, def.gravity),
    COLUMN(scree_world, def.contact_hertz),
    COLUMN(scree_world, def.contact_damping_ratio),
    COLUMN(scree_world, def.contact_push_speed),
    COLUMN(scree_world, def.restitution_threshold),
    COLUMN(scree_world, def.max_speed),
    COLUMN(scree_world, def.contact_limit),
    COLUMN(scree_world, def.contact_details),
    COLUMN(scree_world, def.hit_speed),
    COLUMN(scree_world, def.hit_impulse),
    COLUMN(scree_world, def.sleep),
    COLUMN(scree_world, def.sleep_threshold),
    COLUMN(scree_world, ruled),
    COLUMN(scree_world, bodies.used),
    COLUMN(scree_world, collidables.used),
    COLUMN(scree_world, attribute_slots.used),
    COLUMN(scree_world, joints.used),
    COLUMN(scree_world, paths.used),
    COLUMN(scree_world, fields.slots.used),
    COLUMN(scree_world, exclusions.slots.used),
    COLUMN(scree_world, first_path),
    COLUMN(scree_world, last_path),
    COLUMN(scree_world, samples_used),
    COLUMN(scree_world, sample_end),
    COLUMN(scree_world, dynamic_bodies),
    COLUMN(scree_world, disabled_bodies),
    COLUMN(scree_world, kinematic_count),
    COLUMN(scree_world, own_masses),
    COLUMN(scree_world, mass_sums.mass),
    COLUMN(scree_world, mass_sums.x),
    COLUMN(scree_world, mass_sums.y),
    COLUMN(scree_world, mass_sums.body),
    COLUMN_INDEX(scree_world, mass_sums.last),
    COLUMN(scree_world, target_count),
    COLUMN(scree_world, edits.sample_rows),
    COLUMN(scree_world, edits.attribute_rows),
    COLUMN(scree_world, reports.reporters),
    COLUMN(scree_world, reports.departed_capacity),
    COLUMN_ARRAY(scree_world, reports.counts, int),
    COLUMN(scree_world, reports.allowed_count),
    COLUMN(scree_world, reports.answered),
    COLUMN(scree_world, reports.lost),
    COLUMN(scree_world, sensors.alive),
    COLUMN(scree_world, sensors.visit_count),
    COLUMN(scree_world, sensors.began_count),
    COLUMN(scree_world, sensors.ended_count),
};

static const Column pipeline_columns[] = {
    COLUMN(Pipeline, trees[0].unsorted),
    COLUMN(Pipeline, trees[1].unsorted),
    COLUMN(Pipeline, trees[0].outliers),
    COLUMN(Pipeline, trees[1].outliers),
    COLUMN(Pipeline, trees[0].churned),
    COLUMN(Pipeline, trees[1].churned),
    COLUMN(Pipeline, step.dt),
    COLUMN(Pipeline, step.h),
    COLUMN(Pipeline, step.inv_h),
    COLUMN(Pipeline, step.gravity_x),
    COLUMN(Pipeline, step.gravity_y),
    COLUMN(Pipeline, step.max_speed),
    COLUMN(Pipeline, step.max_spin),
    COLUMN(Pipeline, step.push_speed),
    COLUMN(Pipeline, step.restitution_threshold),
    COLUMN(Pipeline, step.fall),
    COLUMN(Pipeline, step.pair),
    COLUMN(Pipeline, step.fixed),
    COLUMN(Pipeline, step.h_ratio),
    COLUMN(Pipeline, step.has_rolling),
    COLUMN(Pipeline, step.heavy),
    COLUMN(Pipeline, step.belts),
    COLUMN(Pipeline, step.segments),
    COLUMN(Pipeline, step.details),
    COLUMN(Pipeline, step.reports),
    COLUMN(Pipeline, step.rules),
    COLUMN(Pipeline, step.material_pairs),
    COLUMN(Pipeline, step.excluded),
    COLUMN(Pipeline, step.asks),
    COLUMN(Pipeline, step.hit_speed),
    COLUMN(Pipeline, step.hit_impulse),
    COLUMN(Pipeline, step.bounces),
    COLUMN(Pipeline, step.joints),
    COLUMN(Pipeline, step.calm),
    COLUMN(Pipeline, step.chain_places),
    COLUMN(Pipeline, step.has_drives),
    COLUMN(Pipeline, step.springs),
    COLUMN(Pipeline, step.couplings),
    COLUMN(Pipeline, step.paths),
    COLUMN(Pipeline, step.kinematic),
    COLUMN(Pipeline, step.presses),
    COLUMN(Pipeline, step.round),
    COLUMN(Pipeline, step.small),
    COLUMN(Pipeline, step.sleep),
    COLUMN(Pipeline, step.sleep_threshold),
    COLUMN(Pipeline, step.continuous_way),
    COLUMN(Pipeline, step.continuous_reach),
    COLUMN(Pipeline, step.collidables),
    COLUMN(Pipeline, step.contact_limit),
    COLUMN(Pipeline, sparse),
    COLUMN(Pipeline, jumps),
    COLUMN(Pipeline, sleeps),
    COLUMN(Pipeline, collidables),
    COLUMN(Pipeline, settles),
    COLUMN(Pipeline, quiet),
    COLUMN(Pipeline, rested),
    COLUMN(Pipeline, skipped),
    COLUMN(Pipeline, surfaces_changed),
    COLUMN(Pipeline, reports),
    COLUMN(Pipeline, rules),
    COLUMN(Pipeline, platforms),
    COLUMN(Pipeline, material_pairs),
    COLUMN(Pipeline, excluded),
    COLUMN(Pipeline, asks),
    COLUMN(Pipeline, reverted),
    COLUMN(Pipeline, has_rolling),
    COLUMN(Pipeline, heavy),
    COLUMN(Pipeline, belts),
    COLUMN(Pipeline, segments),
    COLUMN(Pipeline, statics),
    COLUMN(Pipeline, bounces),
    COLUMN(Pipeline, round),
    COLUMN(Pipeline, has_drives),
    COLUMN(Pipeline, springs),
    COLUMN(Pipeline, couplings),
    COLUMN(Pipeline, paths),
    COLUMN(Pipeline, unlocked),
    COLUMN(Pipeline, tethers),
    COLUMN(Pipeline, can_break),
    COLUMN(Pipeline, chain_places),
    COLUMN(Pipeline, dirty),
    COLUMN(Pipeline, continuous_way),
    COLUMN(Pipeline, continuous_reach),
    COLUMN(Pipeline, taut),
    COLUMN(Pipeline, rounds),
    COLUMN(Pipeline, steps),
    COLUMN(Pipeline, tells),
    COLUMN(Pipeline, grown),
};

static const Column counter_columns[] = {
    COLUMN(Counters, contacts),
    COLUMN(Counters, joints),
    COLUMN(Counters, presses),
    COLUMN(Counters, ways),
    COLUMN(Counters, belts),
    COLUMN(Counters, alive),
    COLUMN(Counters, touching),
    COLUMN(Counters, woken),
    COLUMN(Counters, joined_islands),
    COLUMN(Counters, touched),
    COLUMN(Counters, movers),
    COLUMN(Counters, drowsy),
    COLUMN(Counters, hubs),
    COLUMN(Counters, split),
    COLUMN_ARRAY(Counters, outliers, int),
    COLUMN(Counters, updated_boxes),
    COLUMN(Counters, changed),
    COLUMN(Counters, kept),
    COLUMN(Counters, created),
    COLUMN(Counters, released),
    COLUMN(Counters, settling),
    COLUMN(Counters, gathered),
    COLUMN(Counters, entered),
    COLUMN(Counters, penetration),
    COLUMN(Counters, joint_gap),
    COLUMN(Counters, taut),
    COLUMN(Counters, nonfinite),
    COLUMN(Counters, first_nonfinite),
    COLUMN_ARRAY(Counters, press, int),
    COLUMN(Counters, continuous_items),
    COLUMN(Counters, held),
    COLUMN(Counters, joint_moved),
    COLUMN(Counters, joints_dirty),
    COLUMN(Counters, overflow_first),
    COLUMN(Counters, overflow),
    COLUMN(Counters, joined),
    COLUMN(Counters, joint_events),
    COLUMN(Counters, touches_began),
    COLUMN(Counters, touches_ended),
    COLUMN(Counters, hits),
    COLUMN(Counters, waiting),
    COLUMN(Counters, refused),
    COLUMN(Counters, asked),
    COLUMN(Counters, holds),
    COLUMN(Counters, moved_bodies),
#define CONSTRAINT_KIND(kind, Kind, KIND)                             \
	COLUMN_ARRAY(Counters, layout[CONSTRAINT_##KIND].begin, int),     \
	    COLUMN_ARRAY(Counters, layout[CONSTRAINT_##KIND].count, int), \
	    COLUMN_ARRAY(Counters, layout[CONSTRAINT_##KIND].first, int), \
	    COLUMN_ARRAY(Counters, layout[CONSTRAINT_##KIND].last, int),
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
};

static const Column body_columns[] = {
    COLUMN(HostBody, type),
#define X(name, least, most, value) COLUMN(HostBody, values.name),
#define KEPT(type, name)            COLUMN(HostBody, name),
#include "pools/body_values.def"
    COLUMN(HostBody, mass),
    COLUMN(HostBody, own_mass),
    COLUMN_INDEX(HostBody, first_collidable),
    COLUMN_INDEX(HostBody, last_collidable),
    COLUMN(HostBody, collidables),
    COLUMN(HostBody, first_joint),
    COLUMN(HostBody, arm),
    COLUMN(HostBody, first_exclusion),
    COLUMN(HostBody, exclusions),
    COLUMN(HostBody, fields),
    COLUMN(HostBody, target),
    COLUMN(HostBody, kinematic),
    COLUMN(HostBody, stands),
    COLUMN(HostBody, from),
    COLUMN(HostBody, went),
    COLUMN(HostBody, still),
};

static const Column collidable_columns[] = {
    COLUMN(HostCollidable, attribute),      COLUMN_INDEX(HostCollidable, body),
    COLUMN(HostCollidable, pose),           COLUMN(HostCollidable, filter.category),
    COLUMN(HostCollidable, filter.mask),    COLUMN(HostCollidable, filter.group),
    COLUMN(HostCollidable, reports),        COLUMN(HostCollidable, sensor),
    COLUMN(HostCollidable, user),           COLUMN_INDEX(HostCollidable, next),
    COLUMN_INDEX(HostCollidable, previous), COLUMN(HostCollidable, made),
    COLUMN(HostCollidable, born),
};

#define SHAPE_COLUMNS(type, shape)                                                                                 \
	COLUMN(type, shape.kind), COLUMN(type, shape.count), COLUMN(type, shape.radius), COLUMN(type, shape.vertices), \
	    COLUMN(type, shape.normals), COLUMN(type, shape.centroid), COLUMN(type, shape.area),                       \
	    COLUMN(type, shape.inertia), COLUMN(type, shape.reach)

static const Column attribute_def_columns[] = {
    SHAPE_COLUMNS(scree_attribute_def, shape),
    COLUMN(scree_attribute_def, density),
    COLUMN(scree_attribute_def, friction),
    COLUMN(scree_attribute_def, restitution),
    COLUMN(scree_attribute_def, rolling_resistance),
    COLUMN(scree_attribute_def, tangent_speed),
    COLUMN(scree_attribute_def, one_way),
    COLUMN(scree_attribute_def, material),
};

static const Column attribute_columns[] = {
    COLUMN(HostAttribute, claims),
    COLUMN(HostAttribute, collidables),
};

#define COORDINATE_COLUMNS(c)                                                                                         \
	COLUMN(HostJoint, def.coordinates[c].target), COLUMN(HostJoint, def.coordinates[c].locked),                       \
	    COLUMN(HostJoint, def.coordinates[c].limited), COLUMN(HostJoint, def.coordinates[c].spring),                  \
	    COLUMN(HostJoint, def.coordinates[c].motor), COLUMN(HostJoint, def.coordinates[c].lock_hertz),                \
	    COLUMN(HostJoint, def.coordinates[c].lock_damping_ratio), COLUMN(HostJoint, def.coordinates[c].lower),        \
	    COLUMN(HostJoint, def.coordinates[c].upper), COLUMN(HostJoint, def.coordinates[c].spring_hertz),              \
	    COLUMN(HostJoint, def.coordinates[c].spring_damping_ratio), COLUMN(HostJoint, def.coordinates[c].spring_max), \
	    COLUMN(HostJoint, def.coordinates[c].spring_push), COLUMN(HostJoint, def.coordinates[c].spring_pull),         \
	    COLUMN(HostJoint, def.coordinates[c].motor_speed), COLUMN(HostJoint, def.coordinates[c].motor_max)

#define SIDE_COLUMNS(s)                                                            \
	COLUMN(HostJoint, def.sides[s].measure), COLUMN(HostJoint, def.sides[s].base), \
	    COLUMN(HostJoint, def.sides[s].initial_angle)

static const Column joint_columns[] = {
    COLUMN(HostJoint, def.type),
    COLUMN(HostJoint, def.body_a),
    COLUMN(HostJoint, def.body_b),
    COLUMN(HostJoint, def.frame_a),
    COLUMN(HostJoint, def.frame_b),
    COORDINATE_COLUMNS(0),
    COORDINATE_COLUMNS(1),
    COORDINATE_COLUMNS(2),
    COLUMN(HostJoint, def.hertz),
    COLUMN(HostJoint, def.damping_ratio),
    COLUMN(HostJoint, def.collide_connected),
    COLUMN(HostJoint, def.can_break),
    COLUMN(HostJoint, def.disabled),
    COLUMN(HostJoint, def.elliptic),
    COLUMN(HostJoint, def.force_threshold),
    COLUMN(HostJoint, def.torque_threshold),
    COLUMN(HostJoint, def.user),
    COLUMN(HostJoint, def.ratio),
    SIDE_COLUMNS(0),
    SIDE_COLUMNS(1),
    COLUMN(HostJoint, def.path),
    COLUMN(HostJoint, def.initial_along),
    COLUMN(HostJoint, bodies[0]),
    COLUMN(HostJoint, bodies[1]),
    COLUMN(HostJoint, next[0]),
    COLUMN(HostJoint, next[1]),
    COLUMN(HostJoint, previous[0]),
    COLUMN(HostJoint, previous[1]),
    COLUMN(HostJoint, born),
    COLUMN_INDEX(HostJoint, spot),
    COLUMN_INDEX(HostJoint, path),
};

static const Column path_columns[] = {
    COLUMN(HostPath, first), COLUMN(HostPath, segments), COLUMN(HostPath, name),     COLUMN(HostPath, user),
    COLUMN(HostPath, uses),  COLUMN(HostPath, next),     COLUMN(HostPath, previous),
};

static const Column field_columns[] = {
    COLUMN_INDEX(HostField, body),       COLUMN(HostField, def.type),
    COLUMN(HostField, def.body),         COLUMN(HostField, def.pose),
    SHAPE_COLUMNS(HostField, def.shape), COLUMN(HostField, def.disabled),
    COLUMN(HostField, def.category),     COLUMN(HostField, def.mask),
    COLUMN(HostField, def.acceleration), COLUMN(HostField, def.force),
    COLUMN(HostField, def.strength),     COLUMN(HostField, def.falloff),
    COLUMN(HostField, def.radius),       COLUMN(HostField, def.softening),
    COLUMN(HostField, def.velocity),     COLUMN(HostField, def.density),
    COLUMN(HostField, def.drag),         COLUMN(HostField, def.lift),
    COLUMN(HostField, def.linear_drag),  COLUMN(HostField, def.quadratic_drag),
    COLUMN(HostField, def.spin_drag),    COLUMN(HostField, def.spin_drag_quadratic),
    COLUMN(HostField, def.user),
};

static const Column exclusion_columns[] = {
    COLUMN(HostExclusion, bodies[0]), COLUMN(HostExclusion, bodies[1]),   COLUMN(HostExclusion, next[0]),
    COLUMN(HostExclusion, next[1]),   COLUMN(HostExclusion, previous[0]), COLUMN(HostExclusion, previous[1]),
};

static const Column target_columns[] = {
    COLUMN_ALL(Target, body),
    COLUMN(Target, pose),
};

static const Column visit_columns[] = {
    COLUMN_ALL(Visit, sensor), COLUMN(Visit, visitor), COLUMN(Visit, time),
    COLUMN(Visit, left),       COLUMN(Visit, lasts),   COLUMN(Visit, before),
};

static const Column name_columns[] = {
    COLUMN(CollidableName, collidable),
    COLUMN(CollidableName, body),
    COLUMN(CollidableName, user),
    COLUMN_INDEX(CollidableName, step),
};

#define TABLE(prefix, columns, type)                \
	{                                               \
		COLUMN_TABLE(prefix, columns), sizeof(type) \
	}

const HostColumns host_columns[HOST_TABLES] = {
    [HOST_WORLD] = TABLE("world", world_columns, scree_world),
    [HOST_PIPELINE] = TABLE("pipeline", pipeline_columns, Pipeline),
    [HOST_COUNTERS] = TABLE("counters", counter_columns, Counters),
    [HOST_BODY] = TABLE("body", body_columns, HostBody),
    [HOST_COLLIDABLE] = TABLE("collidable", collidable_columns, HostCollidable),
    [HOST_ATTRIBUTE_DEF] = TABLE("attribute.def", attribute_def_columns, scree_attribute_def),
    [HOST_ATTRIBUTE] = TABLE("attribute", attribute_columns, HostAttribute),
    [HOST_JOINT] = TABLE("joint", joint_columns, HostJoint),
    [HOST_PATH] = TABLE("path", path_columns, HostPath),
    [HOST_FIELD] = TABLE("field", field_columns, HostField),
    [HOST_EXCLUSION] = TABLE("exclusion", exclusion_columns, HostExclusion),
    [HOST_TARGET] = TABLE("target", target_columns, Target),
    [HOST_VISIT] = TABLE("visit", visit_columns, Visit),
    [HOST_VISIT_BEGAN] = TABLE("visit.began", visit_columns, Visit),
    [HOST_VISIT_ENDED] = TABLE("visit.ended", visit_columns, Visit),
    [HOST_DEPARTED] = TABLE("departed", name_columns, CollidableName),
};
