// SPDX-License-Identifier: MIT
// draw_rows.h -- reads the arrays of a device from which a world is drawn and its collidables are listed.
#ifndef DRAW_ROWS_H
#define DRAW_ROWS_H
#include "world/world.h"

typedef struct // arrays of the device; null: not read, because nothing needs it
{
	WorldShape* placed; // render rows, per collidable
	Float4* poses;      // poses of the centers of mass, per body
	BodyState* states;  // velocities, per body
	int* asleep;        // 1 if a body sleeps, per body
	Float4* boxes;      // enlarged boxes, per collidable
	int* joint_flags;   // JOINT_* bits, per joint
	scree_contact* contacts;
	int contact_count;
	int frozen; // first body that was frozen in the last step, -1 for none
} DrawRows;

// Reads the arrays that flags (SCREE_DRAW_*) need. *rows is released by draw_rows_release, also after a failure.
scree_status draw_rows_read(scree_world* world, const char* function, uint32_t flags, DrawRows* rows);
void draw_rows_release(DrawRows* rows);

// Checks the box of a call, and sets *view to it; to all numbers if the box is null.
scree_status draw_view(const char* function, const scree_box* box, scree_box* view);

// Returns the pose in the world of a collidable that exists, its body disabled or not.
scree_pose draw_place(const scree_world* world, const DrawRows* rows, int collidable);

// Transforms the vertices of a shape to the world. Returns the bounding box of the shape.
scree_box draw_outline(const scree_shape* shape, scree_pose pose, scree_vec vertices[SCREE_MAX_VERTICES]);

// Returns whether a shape at a pose may overlap a box: false only if its reach excludes it.
static inline bool draw_is_near(const scree_shape* shape, scree_vec at, const scree_box* view)
{
	// the reach is rounded to float, and so are positions, whose spacing is at most 8 mm
	float reach = shape->reach * 1.001f + 0.02f;
	return at.x - reach <= view->upper.x && at.x + reach >= view->lower.x && at.y - reach <= view->upper.y &&
	       at.y + reach >= view->lower.y;
}

static inline bool draw_overlaps(const scree_box* a, const scree_box* b)
{
	return a->lower.x <= b->upper.x && b->lower.x <= a->upper.x && a->lower.y <= b->upper.y && b->lower.y <= a->upper.y;
}

static inline bool draw_is_disabled(const scree_world* world, int collidable)
{
	int body = world->host_collidables[collidable].body;
	return body >= 0 && world->host_bodies[body].disabled;
}

#endif
