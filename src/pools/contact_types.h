// SPDX-License-Identifier: MIT
// contact_types.h -- declares the data of contacts: flags, manifolds, reports and events, and the spokes of hubs.
#ifndef CONTACT_TYPES_H
#define CONTACT_TYPES_H
#include "pools/collidable_types.h"

// Number that a contact with a kinematic collidable adds to an item of the pool fixed_contacts. A contact with a static
// collidable adds 1.
#define KINEMATIC_CONTACT         65536
#define STATIC_CONTACTS(fixed)    ((fixed) & (KINEMATIC_CONTACT - 1))
#define KINEMATIC_CONTACTS(fixed) ((Word)(fixed) / KINEMATIC_CONTACT)

// Bits of the pool contact_flags.
#define CONTACT_COUNT    3u    // mask of the number of points
#define CONTACT_FRESH    4u    // the contact was created in this step
#define CONTACT_DETECTED 8u    // one collidable has no body: the contact has points but no impulses
#define CONTACT_TOUCHING 16u   // the contact has points
#define CONTACT_JOINED   8192u // a joint or an exclusion keeps the two bodies from touching
#define CONTACT_REPORT   14    // position of the lowest bit of CONTACT_REPORTS: REPORT_* bits of both collidables
#define CONTACT_REPORTS  ((REPORT_TOUCHES | REPORT_HITS) << CONTACT_REPORT)
#define CONTACT_TOUCHED  65536u  // a touch has begun, so its end will be reported
#define CONTACT_PASSES   131072u // one collidable is a one-way platform that lets the other one through
#define CONTACT_IGNORED  262144u // the materials of the two collidables ignore each other
// States of a contact that needs the approval of the user.
#define CONTACT_PENDING   524288u  // not approved: the contact gets no impulses
#define CONTACT_WAITED    1048576u // listed for the user in the last step
#define CONTACT_REFUSED   2097152u // refused by the user, or left without a decision
#define CONTACT_APPROVED  4194304u // approved by the user: the contact acts until its boxes part
#define CONTACT_APPROVALS (CONTACT_PENDING | CONTACT_WAITED | CONTACT_REFUSED | CONTACT_APPROVED)
#define CONTACT_HIGH      8388608u  // set with CONTACT_PASSES if the visitor is higher than the platform, but beside it
#define CONTACT_STATIC    16777216u // one collidable was static when the contact was created
#define CONTACT_KINEMATIC 33554432u // one collidable was kinematic when the contact was created
#define CONTACT_FIXED     (CONTACT_STATIC | CONTACT_KINEMATIC)
#define CONTACT_SUNK      67108864u  // the depth of the contact in a platform was computed in this step
#define CONTACT_ASLEEP    134217728u // touches, but has no constraint because a body sleeps; its impulses are kept
#define CONTACT_APART     (CONTACT_JOINED | CONTACT_PASSES | CONTACT_IGNORED) // such a contact has no points
#define CONTACT_LASTS                                                                                          \
	(CONTACT_DETECTED | CONTACT_REPORTS | CONTACT_TOUCHED | CONTACT_APPROVALS | CONTACT_HIGH | CONTACT_FIXED | \
	 CONTACT_SUNK | CONTACT_ASLEEP) // bits that narrow_phase preserves
#define CONTACT_LOOK 2048u          // narrow_phase must process the contact
#define CONTACT_ANEW 4096u          // narrow_phase must compute a new manifold
// Bits of contact_flags that describe the manifold, and the motion of its points with the bodies.
#define MANIFOLD_ROLLS    32  // the points follow the corners of rolling shapes; otherwise they are fixed to the shapes
#define MANIFOLD_CORNER1  64  // point 1 is at a corner of shape a; otherwise at a corner of shape b
#define MANIFOLD_CORNER2  128 // point 2 is at a corner of shape a; otherwise at a corner of shape b
#define MANIFOLD_TURNS_B  256 // the normal turns with shape b; otherwise with shape a
#define MANIFOLD_CORNERS  512 // the normal points from a corner of shape a to a corner of shape b
#define MANIFOLD_OVERLAPS 1024 // the shapes overlapped at some point when the manifold was computed

typedef struct // 64 bytes: the manifold of a contact, at the time when it was computed
{
	Float4 normal; // x, y: normal to shape b, in the frame of shape a; z, w: separations of points 1, 2, m, or NO_POINT
	Float4 on_a;   // m: positions of points 1 (x, y) and 2 (z, w) in the frame of shape a
	Float4 relative; // pose of shape b in the frame of shape a at that time: x, y (m), cos, sin
	// x, y: rotation of shape a (cos, sin) at that time; renewed when a sliding pair keeps the manifold. z: reach of
	// shape a, m. w: maximum displacement of the shapes for which the manifold is kept, m; -1 if it is predicted
	Float4 then;
} LocalManifold;

typedef struct // 96 bytes: a contact as reported to the user
{
	Int2 pair, feature;
	Word flags;
	int color;
	float normal_x, normal_y;       // unit normal from collidable a to b
	Float4 point;                   // m: positions of points 1 (x, y) and 2 (z, w)
	Float4 impulse;                 // N s: normal impulses of points 1 and 2, then their tangent impulses
	Float4 detail;                  // points 1 and 2: normal impulses of all substeps, N s; then approach speeds, m/s
	float separation1, separation2; // m: separations at points 1 and 2
	float unused[2];
} ContactReport;

typedef struct // data of MAX_LANES spokes; only the members `parts` and `hub_parts` outlive a pass
{
	float parts[MAX_LANES];     // number of parts into which the neighbor is split (hub_order)
	float hub_parts[MAX_LANES]; // number of parts into which the hub is split; stored at its first spoke
	float hub_x[MAX_LANES], hub_y[MAX_LANES], hub_w[MAX_LANES]; // velocity of a part of the hub; at its first spoke
	float vx[MAX_LANES], vy[MAX_LANES], w[MAX_LANES];           // velocity of a part of the neighbor
	float inv_mass[MAX_LANES], inv_inertia[MAX_LANES];          // inverse mass and inertia of the whole neighbor
	float gap1[MAX_LANES], gap2[MAX_LANES];                     // m: gaps at points 1 and 2
	// Direction of a unit impulse on the hub, and its moments about the hub's center at points 1 and 2, m.
	float push_x[MAX_LANES], push_y[MAX_LANES], arm1[MAX_LANES], arm2[MAX_LANES];
	float slope1[MAX_LANES], slope2[MAX_LANES]; // m/s: velocity errors with the old impulses
	// 1/kg: change of velocity by a unit impulse at the same point (mass1, mass2) or at the other point (cross).
	float mass1[MAX_LANES], mass2[MAX_LANES], cross[MAX_LANES];
	// Inverses of mass1, of mass2, and of 1 - cross^2 / (mass1 mass2).
	float inverse1[MAX_LANES], inverse2[MAX_LANES], inverse[MAX_LANES];
	float old1[MAX_LANES], old2[MAX_LANES], new1[MAX_LANES], new2[MAX_LANES]; // N s: old and new impulses
	float limit1[MAX_LANES], limit2[MAX_LANES]; // N s: largest impulses; or 1 for a point that is solved, else 0
} Spokes;

#define spoke_at(p, component, k) ((p)->spokes[(k) / MAX_LANES].component[(k) % MAX_LANES])

#define EVENT_TOUCH_BEGAN 0
#define EVENT_TOUCH_ENDED 1
#define EVENT_HIT         2
#define EVENT_APPROVALS   3
#define EVENT_LISTS       4

#endif
