// SPDX-License-Identifier: MIT
// contact_types.h -- declares the data of contacts: flags, manifolds, reports and events, and the spokes of hubs.
#ifndef CONTACT_TYPES_H
#define CONTACT_TYPES_H
#include "pools/collidable_types.h"

// Weight of a contact with a kinematic collidable in the pool fixed_contacts; with a static one the weight is 1.
#define KINEMATIC_CONTACT         65536
#define STATIC_CONTACTS(fixed)    ((fixed) & (KINEMATIC_CONTACT - 1))
#define KINEMATIC_CONTACTS(fixed) ((Word)(fixed) / KINEMATIC_CONTACT)

// Bits of the pool contact_flags.
#define CONTACT_COUNT    3u    // mask of the number of points
#define CONTACT_FRESH    4u    // the contact was created in this step
#define CONTACT_DETECTED 8u    // detects only: one collidable has no body, so there are no impulses
#define CONTACT_TOUCHING 16u   // the contact has points
#define CONTACT_JOINED   8192u // a joint or an exclusion keeps the two bodies from touching
#define CONTACT_REPORT   14    // position of the first REPORT_* bit that a contact takes from its collidables
#define CONTACT_REPORTS  ((REPORT_TOUCHES | REPORT_HITS) << CONTACT_REPORT)
#define CONTACT_TOUCHED  65536u  // a touch has begun, so its end will be reported
#define CONTACT_PASSES   131072u // one side is a one-way platform that lets the other side through
#define CONTACT_IGNORED  262144u // the pair of materials is set to ignored
// States of a contact that needs the approval of the user.
#define CONTACT_PENDING   524288u  // no decision yet: gets no impulses
#define CONTACT_WAITED    1048576u // listed for the user in the last step
#define CONTACT_REFUSED   2097152u // refused by the user, or left without a decision
#define CONTACT_APPROVED  4194304u // approved by the user: the contact acts until its boxes part
#define CONTACT_APPROVALS (CONTACT_PENDING | CONTACT_WAITED | CONTACT_REFUSED | CONTACT_APPROVED)
#define CONTACT_HIGH      8388608u  // passing: the visitor was above but beside the platform; it may be stopped later
#define CONTACT_STATIC    16777216u // one side was static when the contact was created
#define CONTACT_KINEMATIC 33554432u // one side was kinematic when the contact was created
#define CONTACT_FIXED     (CONTACT_STATIC | CONTACT_KINEMATIC)
#define CONTACT_SUNK      67108864u // the depth of the contact in a platform was computed in this step
#define CONTACT_APART     (CONTACT_JOINED | CONTACT_PASSES | CONTACT_IGNORED) // contacts with one of these: no points
#define CONTACT_LASTS                                                                                          \
	(CONTACT_DETECTED | CONTACT_REPORTS | CONTACT_TOUCHED | CONTACT_APPROVALS | CONTACT_HIGH | CONTACT_FIXED | \
	 CONTACT_SUNK)         // bits that narrow_phase preserves
#define CONTACT_LOOK 2048u // narrow_phase must process the contact
#define CONTACT_ANEW 4096u // narrow_phase must compute a new manifold
// More bits of contact_flags: they define how the manifold follows the bodies.
#define MANIFOLD_ROLLS    32   // the points follow the corners of the shapes; otherwise they stay where they were found
#define MANIFOLD_CORNER1  64   // point 1 is at a corner of shape a; otherwise at a corner of shape b
#define MANIFOLD_CORNER2  128  // point 2 is at a corner of shape a; otherwise at a corner of shape b
#define MANIFOLD_TURNS_B  256  // the normal turns with shape b; otherwise with shape a
#define MANIFOLD_CORNERS  512  // the normal points from a corner of a shape to a corner of the other
#define MANIFOLD_OVERLAPS 1024 // some point overlapped when the manifold was computed

typedef struct // 64 bytes: the points of a contact at the time when they were found
{
	Float4 normal;   // unit normal to shape b, in the frame of shape a; separations of points, m, or NO_POINT
	Float4 on_a;     // m: x, y of points 1 and 2 in the frame of shape a
	Float4 relative; // pose of shape b in the frame of shape a at that time: x, y (m), cos, sin
	// rotation of shape a at that time (cos, sin); reach of shape a, m; maximum displacement of the shapes for which
	// the manifold is kept, m, negative for a predicted manifold
	Float4 then;
} LocalManifold;

typedef struct // 96 bytes: a contact as reported to the user
{
	Int2 pair, feature;
	Word flags;
	int color;
	float normal_x, normal_y;       // unit normal from collidable a to b
	Float4 point;                   // points 1 and 2: x, y, m
	Float4 impulse;                 // N s: normal impulses of points 1 and 2, then their tangent impulses
	Float4 detail;                  // normal impulses of all substeps, N s, and approach speeds, m/s, of points 1 and 2
	float separation1, separation2; // m, of points 1 and 2
	float unused[2];
} ContactReport;

typedef struct // MAX_LANES spokes; only parts and hub_parts outlive a pass
{
	float parts[MAX_LANES];     // number of parts into which the neighbor is split (hub_order)
	float hub_parts[MAX_LANES]; // number of parts of the hub, at its first spoke
	float hub_x[MAX_LANES], hub_y[MAX_LANES], hub_w[MAX_LANES]; // velocity of the hub's part, at its first spoke
	float vx[MAX_LANES], vy[MAX_LANES], w[MAX_LANES];           // velocity of the neighbor's part
	float inv_mass[MAX_LANES], inv_inertia[MAX_LANES];          // 1/kg, 1/(kg m^2): inverses of the whole neighbor
	float gap1[MAX_LANES], gap2[MAX_LANES];                     // m, of points 1 and 2
	float push_x[MAX_LANES], push_y[MAX_LANES], arm1[MAX_LANES], arm2[MAX_LANES]; // effect of a unit impulse on the hub
	float slope1[MAX_LANES], slope2[MAX_LANES];                                   // m/s: derivatives of the energy
	float mass1[MAX_LANES], mass2[MAX_LANES], cross[MAX_LANES]; // 1/kg: velocity changes at the points by unit impulses
	float inverse1[MAX_LANES], inverse2[MAX_LANES], inverse[MAX_LANES]; // inverses of mass1, mass2 and the determinant
	float old1[MAX_LANES], old2[MAX_LANES], new1[MAX_LANES], new2[MAX_LANES]; // N s
	float limit1[MAX_LANES], limit2[MAX_LANES];
} Spokes;

#define spoke_at(p, component, k) ((p)->spokes[(k) / MAX_LANES].component[(k) % MAX_LANES])

#define EVENT_TOUCH_BEGAN 0
#define EVENT_TOUCH_ENDED 1
#define EVENT_HIT         2
#define EVENT_APPROVALS   3
#define EVENT_LISTS       4

#endif
