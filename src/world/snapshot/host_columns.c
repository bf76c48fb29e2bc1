// SPDX-License-Identifier: MIT
// host_columns.c -- lists the columns of the structs on the host that a snapshot contains.
#include "world/snapshot/host_columns.h"
#include "world/world.h"

#define WORLD(member)    COLUMN_COUNTS(scree_world, member, COLUMN_COUNT)
#define PIPELINE(member) COLUMN_COUNTS(Pipeline, member, COLUMN_COUNT)
#define COUNTER(member)  COLUMN_COUNTS(Counters, member, COLUMN_COUNTER)

// Columns of the members of a world and of its definition. The device, its threads and its lanes are not those of a
// snapshot.
static const Column world_columns[] = {
    WORLD(def.gravity),
    WORLD(def.contact_hertz),
    WORLD(def.contact_damping_ratio),
    WORLD(def.contact_push_speed),
    WORLD(def.restitution_threshold),
    WORLD(def.max_speed),
    WORLD(def.contact_limit),
    WORLD(def.contact_details),
    WORLD(def.hit_speed),
    WORLD(def.hit_impulse),
    WORLD(def.sleep),
    WORLD(def.sleep_threshold),
    WORLD(def.length_unit),
    WORLD(ruled),
    WORLD(bodies.used),
    WORLD(collidables.used),
    WORLD(attribute_slots.used),
    WORLD(joints.used),
    WORLD(paths.used),
    WORLD(fields.slots.used),
    WORLD(exclusions.slots.used),
    WORLD(first_path),
    WORLD(last_path),
    WORLD(samples_used),
    WORLD(sample_end),
    WORLD(dynamic_bodies),
    WORLD(disabled_bodies),
    WORLD(kinematic_count),
    WORLD(own_masses),
    WORLD(mass_sums.mass),
    WORLD(mass_sums.x),
    WORLD(mass_sums.y),
    WORLD(mass_sums.body),
    COLUMN_INDEX(scree_world, mass_sums.last),
    WORLD(target_count),
    WORLD(edits.sample_rows),
    WORLD(edits.attribute_rows),
    WORLD(reports.reporters),
    WORLD(reports.departed_capacity),
    COLUMN_ARRAY(scree_world, reports.counts),
    WORLD(reports.allowed_count),
    WORLD(reports.answered),
    WORLD(reports.lost),
    WORLD(sensors.alive),
    WORLD(sensors.visit_count),
    WORLD(sensors.began_count),
    WORLD(sensors.ended_count),
};

static const Column pipeline_columns[] = {
    PIPELINE(trees[0].unsorted),
    PIPELINE(trees[1].unsorted),
    PIPELINE(trees[0].outliers),
    PIPELINE(trees[1].outliers),
    PIPELINE(trees[0].churned),
    PIPELINE(trees[1].churned),
    PIPELINE(step.dt),
    PIPELINE(step.h),
    PIPELINE(step.inv_h),
    PIPELINE(step.gravity_x),
    PIPELINE(step.gravity_y),
    PIPELINE(step.max_speed),
    PIPELINE(step.max_spin),
    PIPELINE(step.push_speed),
    PIPELINE(step.restitution_threshold),
    PIPELINE(step.fall),
    PIPELINE(step.pair),
    PIPELINE(step.fixed),
    PIPELINE(step.h_ratio),
    PIPELINE(step.has_rolling),
    PIPELINE(step.heavy),
    PIPELINE(step.belts),
    PIPELINE(step.segments),
    PIPELINE(step.details),
    PIPELINE(step.reports),
    PIPELINE(step.rules),
    PIPELINE(step.material_pairs),
    PIPELINE(step.excluded),
    PIPELINE(step.asks),
    PIPELINE(step.hit_speed),
    PIPELINE(step.hit_impulse),
    PIPELINE(step.bounces),
    PIPELINE(step.joints),
    PIPELINE(step.calm),
    PIPELINE(step.chain_places),
    PIPELINE(step.has_drives),
    PIPELINE(step.springs),
    PIPELINE(step.couplings),
    PIPELINE(step.paths),
    PIPELINE(step.kinematic),
    PIPELINE(step.presses),
    PIPELINE(step.round),
    PIPELINE(step.small),
    PIPELINE(step.sleep),
    PIPELINE(step.sleep_threshold),
    PIPELINE(step.continuous_way),
    PIPELINE(step.continuous_reach),
    PIPELINE(step.collidables),
    PIPELINE(step.contact_limit),
    PIPELINE(sparse),
    PIPELINE(jumps),
    PIPELINE(sleeps),
    PIPELINE(collidables),
    PIPELINE(settles),
    PIPELINE(quiet),
    PIPELINE(rested),
    PIPELINE(skipped),
    PIPELINE(surfaces_changed),
    PIPELINE(reports),
    PIPELINE(rules),
    PIPELINE(platforms),
    PIPELINE(material_pairs),
    PIPELINE(excluded),
    PIPELINE(asks),
    PIPELINE(reverted),
    PIPELINE(has_rolling),
    PIPELINE(heavy),
    PIPELINE(belts),
    PIPELINE(segments),
    PIPELINE(statics),
    PIPELINE(bounces),
    PIPELINE(round),
    PIPELINE(has_drives),
    PIPELINE(springs),
    PIPELINE(couplings),
    PIPELINE(paths),
    PIPELINE(unlocked),
    PIPELINE(tethers),
    PIPELINE(can_break),
    PIPELINE(chain_places),
    PIPELINE(dirty),
    PIPELINE(continuous_way),
    PIPELINE(continuous_reach),
    PIPELINE(taut),
    PIPELINE(rounds),
    PIPELINE(steps),
    PIPELINE(tells),
    PIPELINE(grown),
};

static const Column counter_columns[] = {
    COUNTER(contacts),
    COUNTER(joints),
    COUNTER(presses),
    COUNTER(ways),
    COUNTER(belts),
    COUNTER(alive),
    COUNTER(touching),
    COUNTER(woken),
    COUNTER(joined_islands),
    COUNTER(touched),
    COUNTER(movers),
    COUNTER(drowsy),
    COLUMN_ARRAY(Counters, stale_layout),
    COUNTER(hubs),
    COUNTER(split),
    COLUMN_ARRAY(Counters, outliers),
    COUNTER(updated_boxes),
    COUNTER(changed),
    COUNTER(kept),
    COUNTER(created),
    COUNTER(released),
    COUNTER(settling),
    COUNTER(gathered),
    COUNTER(entered),
    COLUMN(Counters, penetration),
    COLUMN(Counters, joint_gap),
    COUNTER(taut),
    COUNTER(nonfinite),
    COUNTER(first_nonfinite),
    COLUMN_ARRAY(Counters, press),
    COUNTER(continuous_items),
    COUNTER(held),
    COUNTER(joint_moved),
    COUNTER(joints_dirty),
    COUNTER(overflow_first),
    COUNTER(overflow),
    COUNTER(joined),
    COUNTER(joint_events),
    COUNTER(touches_began),
    COUNTER(touches_ended),
    COUNTER(hits),
    COUNTER(waiting),
    COUNTER(refused),
    COUNTER(asked),
    COUNTER(holds),
    COUNTER(moved_bodies),
#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                             \
	COLUMN_ARRAY(Counters, layout[CONSTRAINT_##KIND].begin), COLUMN_ARRAY(Counters, layout[CONSTRAINT_##KIND].count), \
	    COLUMN_ARRAY(Counters, layout[CONSTRAINT_##KIND].first),                                                      \
	    COLUMN_ARRAY(Counters, layout[CONSTRAINT_##KIND].last),
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
    COLUMN_ALL(HostJoint, bodies[0]), // a joint needs 700 bytes of memory on the host and as many on the device
    COLUMN_ALL(HostJoint, bodies[1]),
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
