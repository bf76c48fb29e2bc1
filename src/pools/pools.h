// SPDX-License-Identifier: MIT
// pools.h -- the types of the pools in pools.def, for C and OpenCL C.
#ifndef POOLS_H
#define POOLS_H
#include "dialect/dialect.h"
#include "pools/query_types.h"

// Ranges of constraints and bodies are padded to a multiple of this, so that every number of lanes divides them.
#define MAX_LANES 16
// Each color of the constraints is padded to a multiple of this, so that no subgroup of a GPU spans two colors.
#define COLOR_PADDING 32

// No two constraints of a color from 0 to COLORS - 1 share a body that can move. Color COLORS contains the spokes, the
// contacts of hubs. The pool color_mask has one bit per color, so more colors would need a wider mask.
#define COLORS     63
#define COLOR_NONE (-1)
#define COLOR_MASK 0x7fffffffffffffffUL // mask of a body with all colors taken

// Bits of a sort key that is a color only. Keys of contacts have more bits if there are hubs, because they also contain
// the hub.
#define COLOR_BITS 7

// A body with more contacts is a hub. Two bodies that are not hubs always have a free color in common, because each has
// at most 31 other contacts.
#define HUB_CONTACTS 32

// Weight, in the pool belts, of a contact with a belt that runs backward. Counts of static bodies may exceed it, but
// only those of bodies that can move are read.
#define BELT_BACK 65536

// Number of hub colors. A pass solves the hubs of each color in turn. The number of a hub defines its color, so that
// hubs that touch are mostly solved one after the other.
#define HUB_COLORS 4

// Layout of a sort key of neighbors: the body from bit 32 on, the color of the hub from this bit on, the number of the
// spoke below.
#define HUB_KEY_COLOR 30

// Coloring rounds before the host checks whether uncolored contacts are left. It must be even, because rounds alternate
// between two lists.
#define MAX_ROUNDS 64

// Arity of the trees: the boxes of 8 children are 128 bytes, a cache line of a GPU.
#define ARITY      8
#define ARITY_BITS 3
#define MAX_LEVELS 8 // 8 bits per level in the 64-bit stack of a traversal: 8^8 = 16.7 million leaves

// Sorting the leaves of a tree costs about as much as this many visits of nodes per leaf.
#define ORDER_VISITS 16
#define OUTLIER_UNIT 64 // scale of Counters.outliers: 16.7 million leaves cannot overflow it

#define HASH_SUMS 1024

// The rows of fewer collidables fit into the second-level cache of a CPU, and are not prefetched.
#define FETCH_COLLIDABLES 8192

// Items of the broad and narrow phase in a chunk of a CPU worker; chunks begin at a multiple of it.
#define CHUNK_ITEMS 64

#define MAX_CORNERS 8 // most corners of the core of a shape

// Contacts are created from this separation on, so that they exist before bodies meet: four times the slop.
#define LINEAR_SLOP          0.005f
#define SPECULATIVE_DISTANCE 0.02f

// Share of its thickness that a body may travel in a step before continuous collision tests its path.
#define CONTINUOUS_TRAVEL 0.2f
#define CONTINUOUS_CROSS  1.0f // the same if only moving shapes are near: the body must get past the middle of one
// Most kinematic bodies with which continuous collision compares a path directly; with more, it searches the tree for
// those nearby.
#define KINEMATIC_FEW 8
// m: overlap with a kinematic or static body from which on a contact starts a press
#define PRESS_FROM  2.0e-5f
#define PRESS_START 0.0001f // m: the same for a static body, in the search for bodies that may be pressed
// m: distance of the anchors of a joint from which on it drags a body that cannot follow
#define PRESS_GAP 0.01f
// m: greatest depth in a static body to which a kinematic one presses a body. A smaller value would remove the small
// overlap at which contacts carry a load.
#define PRESS_MOST 0.015f
// Bits of the argument of the press kernels: the constraint layout may have changed; this is not the first round.
#define PRESS_MAY_WAIT 1
#define PRESS_AGAIN    2
// Fewest collidables of a body per work-item of continuous, and most work-items per body.
#define CONTINUOUS_SHARE 2
#define CONTINUOUS_PARTS 64

// Most bodies, collidables or attributes of a world: the range of the indices in trees.
#define MAX_ITEMS    (1 << 24)
#define MAX_CONTACTS (8 * MAX_ITEMS)

// Sides of an empty box, which overlaps nothing.
#define EMPTY_LOW  1.0e30f
#define EMPTY_HIGH (-1.0e30f)

#define NO_PAIR (~(Word64)0) // sort key behind those of all pairs of bodies

// Separation of a missing point, so large that no impulse ever arises.
#define NO_POINT 1.0e6f

// Events of a collidable that are listed for the user.
#define REPORT_TOUCHES  1u // begin and end of its touches
#define REPORT_HITS     2u // hits that it gives or receives
#define REPORT_APPROVAL 4u // contacts that need approval before they act

// Collidables that a sensor detects; bits of the same word.
#define SENSOR_MOVING  0x100u // those of dynamic and kinematic bodies
#define SENSOR_STATIC  0x200u // those of static bodies, or without a body
#define SENSOR_SENSORS 0x400u // other sensors
#define SENSOR_SHIFT   8
#define SENSOR_BITS    (SENSOR_MOVING | SENSOR_STATIC | SENSOR_SENSORS)

// Bits of the pool collidable_flags.
#define COLLIDABLE_NEW_BOX 1 // the box differs from old_box
#define COLLIDABLE_FAST    2 // the motion of this step may exceed the speculative distance
#define COLLIDABLE_MOVING  4 // the collidable is not at rest in this step
// m: dynamic collidables that are thinner have finer tolerances; twice the speculative distance
#define GRAIN_SIZE (2.0f * SPECULATIVE_DISTANCE)
// Bit k of these is set for a dynamic collidable that is thinner than GRAIN_SIZE / 2^k. The tolerances of a contact are
// halved once for each bit that either collidable has, because they would exceed the smaller body.
#define COLLIDABLE_GRAIN 8 // bit 0
#define GRAIN_LEVELS     5
// The same bits for the reach of a collidable. They scale the distance from which on a pair has points: a long thin
// body needs the points of both ends.
#define COLLIDABLE_REACH  (COLLIDABLE_GRAIN << GRAIN_LEVELS)
#define COLLIDABLE_GRAINS (COLLIDABLE_GRAIN * ((1 << 2 * GRAIN_LEVELS) - 1))

// Kinds of collidables.
#define KIND_DEAD      0
#define KIND_STATIC    1
#define KIND_KINEMATIC 2
#define KIND_DYNAMIC   3
#define KIND_FREE      4 // no body
#define KIND_SENSOR    8 // flag that a sensor adds to its kind

// Count of a contact with a kinematic collidable in the pool fixed_contacts, in which one with a static collidable
// counts 1.
#define KINEMATIC_CONTACT         65536
#define STATIC_CONTACTS(fixed)    ((fixed) & (KINEMATIC_CONTACT - 1))
#define KINEMATIC_CONTACTS(fixed) ((Word)(fixed) / KINEMATIC_CONTACT)

// Bits of the pool contact_flags.
#define CONTACT_COUNT    3u    // mask of the number of points
#define CONTACT_FRESH    4u    // created in this step
#define CONTACT_DETECTED 8u    // detection only: one side has no body, so there are no impulses
#define CONTACT_TOUCHING 16u   // has points
#define CONTACT_JOINED   8192u // a joint or an exclusion keeps the two bodies from touching
#define CONTACT_REPORT   14    // first of the REPORT_* bits that it takes from its collidables
#define CONTACT_REPORTS  ((REPORT_TOUCHES | REPORT_HITS) << CONTACT_REPORT)
#define CONTACT_TOUCHED  65536u  // its touch began, so an end will follow
#define CONTACT_PASSES   131072u // one side is a one-way platform that lets the other one through
#define CONTACT_IGNORED  262144u // the pair of materials is set to ignored
// States of a contact that needs the user's approval.
#define CONTACT_PENDING   524288u  // pending: gets no impulses yet
#define CONTACT_WAITED    1048576u // listed for the user in the last step
#define CONTACT_REFUSED   2097152u // refused, or left without an answer
#define CONTACT_APPROVED  4194304u // approved: acts until the two part
#define CONTACT_APPROVALS (CONTACT_PENDING | CONTACT_WAITED | CONTACT_REFUSED | CONTACT_APPROVED)
#define CONTACT_HIGH      8388608u // passes, but was higher than its platform, so it may be stopped as if it were new
// One side was static, or kinematic, when the contact was created.
#define CONTACT_STATIC    16777216u
#define CONTACT_KINEMATIC 33554432u
#define CONTACT_FIXED     (CONTACT_STATIC | CONTACT_KINEMATIC)
#define CONTACT_SUNK      67108864u // its depth in a platform is already found in this step
#define CONTACT_APART     (CONTACT_JOINED | CONTACT_PASSES | CONTACT_IGNORED) // no points, whatever the poses
#define CONTACT_LASTS                                                                                          \
	(CONTACT_DETECTED | CONTACT_REPORTS | CONTACT_TOUCHED | CONTACT_APPROVALS | CONTACT_HIGH | CONTACT_FIXED | \
	 CONTACT_SUNK) // bits that narrow_phase preserves
// Marks within the narrow phase.
#define CONTACT_LOOK 2048u // narrow_phase must process the contact
#define CONTACT_ANEW 4096u // narrow_phase must compute a new manifold
// Bits of the same word that define how the manifold follows the bodies.
#define MANIFOLD_ROLLS    32   // the points follow the corners of the shapes; otherwise they stay as they were found
#define MANIFOLD_CORNER1  64   // point 1 is at a corner of a, otherwise of b
#define MANIFOLD_CORNER2  128  // the same for point 2
#define MANIFOLD_TURNS_B  256  // the normal turns with b, otherwise with a
#define MANIFOLD_CORNERS  512  // the normal points from a corner to a corner
#define MANIFOLD_OVERLAPS 1024 // some point overlapped

typedef struct // 160 bytes
{
	Float2 vertices[8]; // m, counter-clockwise
	Float2 normals[8];  // outward normal of the edge from vertex i to i + 1
	float radius;       // m
	int count;          // number of vertices: 1 circle, 2 capsule and segment, 3 to 8 polygon
	float friction, restitution, rolling_resistance;
	float tangent_speed; // m/s
	float margin;        // m: distance by which an enlarged box exceeds the tight one
	float reach;         // m: largest distance of a point from the origin
} Attribute;

typedef struct // 16 bytes: properties of an attribute that rules read
{
	float up_x, up_y; // unit vector in the frame of the shape, to the side from which a one-way platform is solid
	int one_way;      // 1 for a one-way platform
	int material;
} Rule;

#define MATERIALS 256

// Bits of MaterialPair.sets.
#define MATERIAL_FRICTION    1
#define MATERIAL_RESTITUTION 2
#define MATERIAL_SPEED       4
#define MATERIAL_IGNORED     8

typedef struct // 16 bytes: surface of a pair of materials, which replaces the mix of their attributes
{
	float friction, restitution;
	float tangent_speed; // m/s, as in Attribute
	int sets;            // MATERIAL_* bits of the values that are set
} MaterialPair;

// Index of the pair of materials low and high in the pool material_pair. Pairs with the same higher material are
// adjacent.
#define MATERIAL_PLACE(low, high) ((high) * ((high) + 1) / 2 + (low))

typedef struct // 16 bytes: data of a dynamic body for continuous collision
{
	int first;   // 1 + index of its first collidable, 0 for none
	int parts;   // number of work-items that share its collidables
	float way;   // m: CONTINUOUS_TRAVEL times the thickness of its thinnest collidable
	float reach; // m: bound of the distance of its points from the center of mass
} ContinuousBody;

typedef struct // 32 bytes: presses on a body
{
	int way[2];         // presses by static and by kinematic bodies: hops left and direction, 0 for none
	int depth;          // float bits of its depth in a static body into which it is pressed, m
	int speed;          // float bits of the speed of the latest press, m/s
	int left;           // steps for which it gets no faster than that press
	int tight;          // 1 if it is still deep in another body
	float before, spun; // its own speed and spin at the start of the step, m/s, rad/s
} Press;

typedef struct // 24 bytes
{
	Word64 category, mask;
	int group;
	Word reports; // REPORT_* and SENSOR_* bits
} Filter;

typedef struct // 64 bytes: the points of a contact, as they were found
{
	Float4 normal;   // x, y from a to b in the frame of a; separations of the points, m, NO_POINT for a missing one
	Float4 on_a;     // points 1 and 2 in the frame of a, m
	Float4 relative; // pose of b in the frame of a at that time: x, y (m), cos, sin
	// Rotation of a in the world at that time: cos, sin; reach of a, m; shift up to which the manifold is kept, m,
	// negative for a predicted manifold.
	Float4 then;
} LocalManifold;

typedef struct // 32 bytes: one memory sector
{
	float x, y, c, s;         // world pose
	float center_x, center_y; // from here to the body's center of mass, world axes, m
	int attribute, body;
} WorldShape;

// Rows of constraints, listed in src/constraints/: blocks of MAX_LANES constraints, with one row per component. A wide
// pass reads the rows of one contiguous block, and a GPU addresses all components of a constraint from one base instead
// of seventeen. The kept types hold the values that survive a change of the layout.
#define CONSTRAINT_KIND(kind, Kind, KIND)         \
	typedef struct Kind##Rows Kind##Rows;         \
	typedef struct Kind##RareRows Kind##RareRows; \
	typedef struct Kind##Kept Kind##Kept;         \
	typedef struct Kind##RareKept Kind##RareKept;
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

typedef struct // 96 bytes: a contact as reported to the user
{
	Int2 pair, feature;
	Word flags;
	int color;
	float normal_x, normal_y;       // unit normal from a to b
	Float4 point;                   // points 1 and 2: x, y, m
	Float4 impulse;                 // normal 1, 2, tangent 1, 2, N s
	Float4 detail;                  // normal impulses of all substeps, N s, and approach speeds, m/s, of points 1 and 2
	float separation1, separation2; // m
	float unused[2];
} ContactReport;

typedef struct // settings that all queries of a call share
{
	Word64 category, mask;
	Word kinds;      // QueryLeaf.kinds that are found
	int all;         // 1 if category and mask have all bits
	int room;        // capacity of the lists of answers
	int found;       // answers found, including those beyond the capacity
	float most;      // m: greatest distance of a nearest collidable
	int skips;       // 1 to skip collidables inside which a query begins
	int rules;       // 1 to find one-way platforms from above only
	int bodies;      // used slots of the pool body_generation
	Attribute shape; // shape of the query; a point for rays
} QueryPlan;

typedef struct // MAX_LANES spokes; all but the first two rows are working data of a pass
{
	float parts[MAX_LANES];     // parts of the neighbor: one per spoke, and one if it is a hub itself
	float hub_parts[MAX_LANES]; // parts of the hub, at its first spoke
	float hub_x[MAX_LANES], hub_y[MAX_LANES], hub_w[MAX_LANES]; // velocity of the hub's part, at its first spoke
	float vx[MAX_LANES], vy[MAX_LANES], w[MAX_LANES];           // velocity of the neighbor's part
	float inv_mass[MAX_LANES], inv_inertia[MAX_LANES];          // masses of the whole neighbor
	float gap1[MAX_LANES], gap2[MAX_LANES];                     // m
	float push_x[MAX_LANES], push_y[MAX_LANES], arm1[MAX_LANES], arm2[MAX_LANES]; // effect of a unit impulse on the hub
	float slope1[MAX_LANES], slope2[MAX_LANES];                                   // m/s: slopes of the energy
	float mass1[MAX_LANES], mass2[MAX_LANES], cross[MAX_LANES];               // 1/kg: velocity changes by unit impulses
	float inverse1[MAX_LANES], inverse2[MAX_LANES], inverse[MAX_LANES];       // inverses of mass1, mass2, determinant
	float old1[MAX_LANES], old2[MAX_LANES], new1[MAX_LANES], new2[MAX_LANES]; // N s
	float limit1[MAX_LANES], limit2[MAX_LANES];
} Spokes;

// A component of spoke k of the pools p.
#define spoke_at(p, component, k) ((p)->spokes[(k) / MAX_LANES].component[(k) % MAX_LANES])

// Bits of the pool joint_flags.
#define JOINT_THERE     1   // the slot holds a joint
#define JOINT_ACTIVE    2   // both bodies are enabled, and at least one can move
#define JOINT_RESTARTS  4   // its constraint has to end and begin again
#define JOINT_BROKEN    8   // it broke
#define JOINT_COLLIDES  16  // its bodies may touch each other
#define JOINT_CAN_BREAK 32  // it breaks when its force or torque exceeds its threshold
#define JOINT_ACTS      64  // it has a lock, a limit, a spring or a motor
#define JOINT_NEW       128 // the slot holds another joint than before
#define JOINT_SEEKS     256 // flag of an edit: a body or a frame was placed, so another part of its path may be nearer

// JointData.modes: a whole number with four bits for each coordinate, followed by other bits.
#define JOINT_LOCKED(k)     (1 << (4 * (k)))
#define JOINT_LIMITED(k)    (2 << (4 * (k)))
#define JOINT_SPRING(k)     (4 << (4 * (k)))
#define JOINT_MOTOR(k)      (8 << (4 * (k)))
#define JOINT_HAS_DRIVES(k) (JOINT_LIMITED(k) | JOINT_SPRING(k) | JOINT_MOTOR(k))
#define JOINT_EXTRAS        0xeee           // limits, springs and motors
#define JOINT_RADIAL        0x1000          // the axis lies along the line between the two anchors
#define JOINT_SOFT(k)       (0x2000 << (k)) // the lock is a spring
#define JOINT_SPRINGS       0xe444          // springs and soft locks
#define JOINT_TURNS         0x10000         // the axis turns with body a
#define JOINT_COUPLED       0x20000         // a gear or a pulley: the coordinate along is that of the coupling

// Measure of a side of a coupling, 0 for a: a translation, a distance, or else an angle.
#define JOINT_SLIDES(side) (0x40000 << (side))
#define JOINT_HOISTS(side) (0x100000 << (side))
#define JOINT_LINEAR(side) (JOINT_SLIDES(side) | JOINT_HOISTS(side))
#define JOINT_ELLIPTIC     0x400000 // springs and motors along and across have a common bound
#define JOINT_RAILED       0x800000 // the axis is the tangent of a path at anchor b

// Coordinates of frame b in frame a.
#define JOINT_ALONG       0
#define JOINT_ACROSS      1
#define JOINT_ANGLE       2
#define JOINT_COORDINATES 3

typedef struct // 16 bytes: the lock of a coordinate, in m or rad
{
	float target;       // value at which a lock holds the coordinate, and to which a spring pulls it
	float hertz, ratio; // frequency and damping ratio of a soft lock; 0 Hz: as stiff as the joint
	float unused;
} JointLock;

typedef struct // 32 bytes: limits, spring and motor of a coordinate, in m or rad, N or N m
{
	float lower, upper;
	float spring_hertz, spring_ratio, spring_least, spring_most;
	float speed, motor_most;
} JointDriveData;

// Offsets in JointData, in rows of four floats.
#define JOINT_QUADS       16
#define JOINT_AT_MODES    0
#define JOINT_AT_FRAME(s) (1 + (s))
#define JOINT_AT_HERTZ    3
#define JOINT_AT_LOCK(k)  (4 + (k))
#define JOINT_AT_BASE(s)  (7 + (s))
#define JOINT_AT_DRIVE(k) (9 + 2 * (k))

typedef struct // 256 bytes; most joints need only the first half
{
	int body_a, body_b;            // index of a body, 0 for the world
	float modes;                   // JOINT_* bits, as a float
	float gear_ratio;              // ratio of a coupling
	Float4 frame[2];               // joint frames in the frames of the bodies: x, y (m), cos, sin
	float hertz, ratio;            // stiffness of rigid locks and limits
	float most_force, most_torque; // thresholds, N, N m
	JointLock lock[JOINT_COORDINATES];
	Float4 base[2]; // bases of a coupling, in the world
	JointDriveData drive[JOINT_COORDINATES];
	// Values with which a new joint begins. Coupling: the angles of its sides are those nearest to these, rad. Path:
	// arc length from which the search starts, m.
	float near[2];
	float path_first, path_segments; // first sample of its path, and number of its samples minus 1
} JointData;

// 32 bytes: a sample of a path, in the frame of the path. The last sample of a closed path equals the first one.
typedef struct
{
	float x, y, tangent_x, tangent_y; // position, m; unit tangent
	float along;                      // m: arc length from the start of the path
	float length;                     // m: length of the curve to the next sample; 0 for the last one of an open path
	float bend;                       // 1/m: curvature, positive to the left
	float unused;
} PathSample;

typedef struct // 272 bytes: a joint as the user defined it
{
	int slot, flags, spot, unused;
	JointData data;
} JointEdit;

// A spot is the index of a joint in the pool chain_joints. The joints of a chain are distributed over R rows, where R
// is a power of two and joint k is in row k mod R. The even rows come first, then the odd ones. Joints of one half have
// no bodies in common, so a wide pass processes a block of them at once. The neighbors of a block form a block too,
// except at the ends of a row. Alternatively, chains of similar lengths are interleaved: joints k of LANES chains are
// one block or a part of one. Then R is 2, and joint k + 2 is MAX_LANES spots behind joint k.
typedef struct // 32 bytes: a chain, or several interleaved ones
{
	int first;  // spot of joint 0
	int count;  // joints of the longest chain; nodes of a branch
	int odds;   // spots from joint 0 to joint 1; of a branch, index of its node 0 in the pool
	int stride; // spots between neighbors in a row: 1, or MAX_LANES
	int length; // joints of a row, including inert ones at its end
	int bits;   // binary logarithm of the number of rows, at least 1
	int parts;  // number of ranges, from this one on, in one item of a pass; 0 for the others of the item
	int item;   // for entry i: the range at which item i of a pass begins
} ChainRange;

// The spot of joint k of a ChainRange.
#define CHAIN_SPOT(c, k)                                                                           \
	((c)->first + ((k)&1) * (c)->odds + (((k) >> 1) & ((1 << (c)->bits >> 1) - 1)) * (c)->length + \
	 ((k) >> (c)->bits) * (c)->stride)

// 32 bytes: a body of a branch, and its joint toward the root. Nodes are sorted by their distance from the root.
typedef struct
{
	int body;         // index of the body
	int side;         // side of the joint at which the body is: 0 for a, 1 for b
	int up;           // parent node, counted from the first node of the branch; -1 if the parent cannot move
	int first, count; // range of child nodes
	int begin, end;   // range of the nodes at the same distance from the root
	int unused;
} BranchNode;

typedef struct // MAX_LANES joints in the linear systems of their chains: working data of a pass
{
	float d[6][MAX_LANES];                       // diagonal block 00, 01, 02, 11, 12, 22; its inverse after elimination
	float l[9][MAX_LANES];                       // block that couples a joint with the previous one
	float m[9][MAX_LANES];                       // block that couples the next joint with it, at the current level
	float r[3][MAX_LANES];                       // right side
	float x[3][MAX_LANES];                       // solution
	float pose[6][MAX_LANES];                    // first axis; levers of both axes on a, and on b
	int body_a[MAX_LANES], body_b[MAX_LANES];    // indices of its bodies
	float locks[MAX_LANES], holds[MAX_LANES];    // bits of coordinates: locked; locked and able to move
	float side[MAX_LANES], other[MAX_LANES];     // shared body, 0 for a, 1 for b: here; at the previous joint
	float inv_mass[MAX_LANES], turns[MAX_LANES]; // 1/kg, 1/(kg m^2): inverses of the shared body; 0 for none
	float tension[2][MAX_LANES];                 // kg m^2: inertia that its pull adds to its bodies
	float own_a[MAX_LANES], own_b[MAX_LANES];    // 1/(kg m^2): own inverse inertias of its bodies
	float step_a[MAX_LANES], step_b[MAX_LANES];  // the same for the step, including the tension
	float slack[MAX_LANES];                      // 1/(kg m^2): softness of the damping of a free angle; 0 for none
} ChainBlock;

// A component of the joint at a spot.
#define chain_at(p, component, spot) ((p)->chain_joints[(spot) / MAX_LANES].component[(spot) % MAX_LANES])

typedef struct // 48 bytes: the state of a joint that the user reads
{
	float value[3], speed[3]; // coordinates and their speeds: m, m, rad; m/s, m/s, rad/s
	float force_x, force_y;   // N: force on body b
	float torque;             // N m
	int broken;
	float unused[2];
} JointState;

typedef struct // 16 bytes
{
	int slot;
	float force, torque; // N, N m: largest of the step
	int broken;
} JointEvent;

typedef struct // 32 bytes: one memory sector, gathered at random by the solver
{
	float vx, vy, w;   // m/s, rad/s
	float inv_mass;    // 1/kg, 0 for static and kinematic bodies, which are never written
	float dx, dy, da;  // m, rad: motion since the start of the step
	float inv_inertia; // 1/(kg m^2)
} BodyState;

typedef struct // 32 bytes
{
	float fx, fy, torque;                  // N, N m; finalize clears them
	float gravity_scale;                   // 0 for static and kinematic bodies
	float linear_damping, angular_damping; // 1/s
	float free_x, free_y;                  // 1, or 0 for a locked axis
} Motion;

typedef struct // 16 bytes: the velocity of a disabled body
{
	float vx, vy, w;
	float stored; // 1, or 0 for an enabled body
} StoredVelocity;

// Kinds of fields, as in scree_field_type.
#define FIELD_UNIFORM  0
#define FIELD_RADIAL   1
#define FIELD_VORTEX   2
#define FIELD_DRAG     3
#define FIELD_WIND     4 // acts on shapes, as the next kind; the others act on bodies
#define FIELD_BUOYANCY 5

// With more fields, boxes around ARITY boxes are tested first.
#define FIELD_FEW (ARITY * ARITY)

// Falloff of a radial field and a vortex, as in scree_field_falloff.
#define FALLOFF_CONSTANT       0
#define FALLOFF_LINEAR         1
#define FALLOFF_INVERSE        2
#define FALLOFF_INVERSE_SQUARE 3

typedef struct // 288 bytes
{
	Attribute shape;       // shape of the region: only corners, normals, radius and count; count 0: everywhere
	Float4 pose;           // pose of the region in the frame of the body, or in the world: x, y (m), cos, sin
	Word64 category, mask; // filter of the bodies or shapes on which it acts
	int all;               // 1 if category and mask have all bits
	int body;              // index of its body, -1 for none
	int kind, falloff;     // FIELD_*, FALLOFF_*
	// Values in the frame of the region.
	float acceleration_x, acceleration_y; // m/s^2
	float force_x, force_y;               // N
	float velocity_x, velocity_y;         // m/s: velocity of the medium
	float strength;                       // m/s^2
	float radius, softening;              // m
	float density;                        // kg/m^2: density of the medium
	float drag, lift;                     // coefficients of a shape in the medium
	float linear_drag, quadratic_drag;    // kg/s, kg/m; linear_drag of a buoyancy field is per 1 m^2
	float spin_drag, spin_drag_quadratic; // N m s, N m s^2
	float unused[4];
} Field;

typedef struct // 48 bytes: a field in this step
{
	Float4 pose;              // pose of its region: x, y (m), cos, sin
	float center_x, center_y; // m: from the position in pose to the center of mass of its body
	float vx, vy, w;          // m/s, rad/s: velocity of that body
	float unused[3];
} FieldSample;

typedef struct // 48 bytes: the force of fields on a body, about its center of mass
{
	float fx, fy, torque;              // N, N m: part that does not depend on the velocity of the body
	float drag_x, drag_y, drag_torque; // N, N m: drag
	// Sums of k, k x, k y and k (x^2 + y^2) over drags k at points x, y: kg/s, kg m/s, kg m^2/s.
	float rate, rate_x, rate_y, rate_w;
	float unused[2];
} FieldForce;

typedef struct // 32 bytes: a change that the user made between steps
{
	int kind;  // COMMAND_*
	int index; // body or collidable
	int whole[2];
	Float4 value;
} Command;

// Command.kind, with the contents of value and whole. Kinds from COMMAND_PLACE on apply to a collidable, the others to
// a body. For kinds below COMMAND_BODY, whole[1] is 1 if that body is disabled.
#define COMMAND_FORCE           0  // x, y: N
#define COMMAND_FORCE_AT        1  // force x, y, world point x, y
#define COMMAND_TORQUE          2  // x: N m
#define COMMAND_IMPULSE         3  // x, y: N s
#define COMMAND_IMPULSE_AT      4  // impulse x, y, world point x, y
#define COMMAND_ANGULAR_IMPULSE 5  // x: N m s
#define COMMAND_VELOCITY        6  // linear x, y, angular
#define COMMAND_POSE            7  // pose of the body's origin: x, y, cos, sin
#define COMMAND_MASS            8  // inverse mass, inverse inertia, local center x, y; the origin does not move
#define COMMAND_MOTION          9  // gravity scale, linear damping, angular damping; whole[0]: locks
#define COMMAND_LINEAR_VELOCITY 10 // x, y: m/s; the spin does not change
#define COMMAND_SPIN            11 // x: rad/s; the linear velocity does not change
#define COMMAND_BODY \
	12 // new row without mass: center of mass x, y, cos, sin; whole: float bits of the center in the body's frame
#define COMMAND_CONTINUOUS 13 // ContinuousBody: first and parts in whole; way in x, reach in y
#define COMMAND_ENABLED    14 // whole[0]: 1, or 0 to disable the body
#define COMMAND_TARGET     15 // pose of the origin x, y, cos, sin at the end of the step; whole[0]: locks
#define COMMAND_ARRIVE     16 // the same after that step: moves the body there, and stops it
#define COMMAND_PLACE      17 // collidable without a body: x, y, cos, sin
#define COMMAND_COLLIDABLE 18 // local pose x, y, cos, sin; whole: attribute, body. Its contacts end, and new ones begin
#define COMMAND_ATTRIBUTE  19 // whole[0]: another attribute of the same shape
#define COMMAND_FILTER     20 // bits of category and mask; whole: group; kind, and REPORT_* bits from bit 8 on
#define COMMAND_NEXT       21 // whole[0]: 1 + index of the body's next collidable, 0 for none
#define COMMAND_REPORTS    22 // whole[0]: REPORT_* bits

// Lists of events.
#define EVENT_TOUCH_BEGAN 0
#define EVENT_TOUCH_ENDED 1
#define EVENT_HIT         2
#define EVENT_APPROVALS   3
#define EVENT_LISTS       4

typedef struct // one tree of the broad phase, as the host fills it
{
	int leaf_begin;        // first item in the leaf pool
	int leaves;            // leaves in use
	int top;               // highest level, the first with at most ARITY nodes; level 0 contains the leaves
	int begin[MAX_LEVELS]; // first item of each level in the pool node_box
	int count[MAX_LEVELS]; // nodes of each level; the pool is padded with empty boxes to a multiple of ARITY
} Tree;

typedef struct // stiffness of a contact: Erin Catto, Soft Constraints, GDC 2011
{
	float bias_rate, mass_scale, impulse_scale;
	float firm, depth; // up to the overlap depth, m, bias_rate is larger by the share firm of itself
} Softness;

// Kinds of constraints. An edge is a constraint of any kind: its kind is in the bits above its slot.
enum
{
#define CONSTRAINT_KIND(kind, Kind, KIND) CONSTRAINT_##KIND,
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	CONSTRAINT_KINDS
};
#define EDGE_KIND 27 // bits of a slot: the range of MAX_CONTACTS

// The kinematic bodies of a world that has at most KINEMATIC_FEW. They are not in Step, because an index that is not
// constant would put Step on a GPU's stack.
typedef struct
{
	int body[KINEMATIC_FEW];
} Kinematics;

typedef struct // constants of one step, passed by value to every kernel
{
	float dt, h, inv_h; // s; substep, s; 1/s
	float gravity_x, gravity_y;
	float max_speed, max_spin; // m/s, rad/s
	float push_speed;          // m/s
	float restitution_threshold;
	float fall;             // m: distance that gravity may move a resting body in a step, with a margin
	Softness pair, fixed;   // softness of contacts between bodies that can move; and with one that cannot
	float h_ratio;          // h divided by that of the last step with dt above 0
	int has_rolling;        // some attribute has restitution, rolling resistance or tangent speed
	int belts;              // some attribute, or pair of materials, has a tangent speed
	int segments;           // some attribute is a segment
	int details;            // contacts must store details of the step for the user
	int reports;            // some collidable reports touches or hits
	int rules;              // some pair may be subject to a rule
	int material_pairs;     // rows of the pool material_pair
	int excluded;           // rows of the pool excluded
	int asks;               // some collidable requires contact approval
	int request_again;      // the contacts that the last step listed have no answer yet, and are listed again
	int allowed;            // rows of the pool allowed
	float hit_speed;        // m/s: slower approaches are not hits
	float hit_impulse;      // N s: smaller impulses are not hits
	int bounces;            // some attribute has restitution
	int joints;             // there may be joints among the constraints
	int calm;               // bodies without contacts and forces move as predicted from their velocities, within 5 mm
	int chain_places;       // number of spots of chains
	int has_drives;         // some joint has a limit, a spring, a motor or a threshold, is a coupling or follows a path
	int springs;            // some joint has a spring or a soft lock
	int couplings;          // some joint is a gear or a pulley
	int paths;              // some joint follows a path
	int kinematic;          // number of kinematic bodies
	int presses;            // static bodies exist, and a kinematic body or a joint may press others against them
	int round;              // some attribute has a radius
	int small;              // some dynamic collidable may be thinner than GRAIN_SIZE
	float continuous_way;   // m: lower bound of all ContinuousBody.way of the world
	float continuous_reach; // m: upper bound of all ContinuousBody.reach
	int collidables;        // slots in use
	int pair_capacity, contact_capacity;
	int place_capacity[CONSTRAINT_KINDS];
	int contact_limit; // most contacts of the world
	// Nodes over leaves that a traversal visits before its rest is split, and number of work-items for the rest.
	int traversal_nodes, traversal_items;
	int key_bits; // bits of a collidable's index in the key of a pair
} Step;

// Returns whether the rare rows of contacts are used.
#define STEP_RARE(step) ((step).has_rolling | (step).details)

typedef struct // places of the constraints of a kind
{
	int begin[COLORS + 2]; // first place of each color; color COLORS contains the spokes
	int count[COLORS + 1]; // constraints of each color, without padding
	int first[COLORS + 2]; // range of each color among the sorted keys of this step: the first, and one past the last
	int last[COLORS + 2];
} KindLayout;

// Counters on the device. All are ints, so that Run.count can identify one by its position.
typedef struct
{
	// Values that persist between steps.
#define CONSTRAINT_KIND(kind, Kind, KIND) int kind##s; // end of the used slots of the kind's pool
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	int presses;                         // INT_MAX if something may be pressed, else 0
	int ways;                            // 1 if some contact passes a press on
	int belts;                           // 1 if a belt was reversed since the last search for hubs
	int alive;                           // live contacts, plus those released in the last step
	int touching;                        // contacts with a color, including spokes
	KindLayout layout[CONSTRAINT_KINDS]; // places of the constraints of each kind
	int hubs;                            // bodies solved together with all of their contacts
	int split;                           // number of spokes if some body is split into parts, else 0
	int outliers[2]; // node visits per traversal wasted on outliers, for each tree, times OUTLIER_UNIT
	// Values of this step.
	int updated_boxes; // collidables whose enlarged box changed
	int changed;       // 1 if a constraint began or ended, so that a new layout is necessary
	int kept;          // INT_MAX if the layout of the last step is valid; 0 if it changed or must not be used
	int refit;         // tree nodes to recompute: all if some box changed, else 0
	int jumped;        // tree nodes to check for outliers: all if some box jumped, else 0
	int order[2];      // leaves of each tree to sort in this step: all, or 0
	int traversals;    // traversals that one work-item did not finish
	int rest;          // work-items among which these are split: all, or 0 without such traversals
	int pairs;         // new pairs found, including those beyond the capacity; incomplete above the limit
	int over_limit;    // 1 if there are more contacts than the limit allows: the rest of the step is skipped
	int sort_pairs;    // new pairs, or 0 if the capacity is too small
	int search;        // contact slots to search for free ones, plus one; 0 without new pairs
	int dead;          // free slots found
	int created;       // new contacts
	int needed;        // contact slots that the step needs
	int stalled;       // 1 if the limit or a capacity is exceeded: the rest is skipped, and the host repeats the step
	int live;          // contact slots that the narrow phase covers
	int look;          // the same if some contact is marked for processing, else 0
	int released;      // contacts whose boxes parted
	int began, ended;  // contacts that began and stopped touching
	int gathered;      // contact slots to search for contacts of new hubs, else 0
	int entered;       // 1 if a contact became a spoke
	int uncolored[MAX_ROUNDS + 1]; // [r + 1]: contacts without a color after coloring round r
	int dirty[CONSTRAINT_KINDS];   // 1 if a constraint of the kind began or ended
	int arrange[CONSTRAINT_KINDS]; // slots of the kind to sort by color; 0 if none began or ended
	int arranged;                  // 1 if all changed kinds were laid out
	int penetration;               // float bits of the deepest overlap, m
	int joint_gap;                 // float bits of the widest gap of a joint, m
	int taut;             // 1 if the pull of some joint was large against the inertia of a body; body_taut clears it
	int nonfinite;        // bodies frozen because their state was not finite
	int first_nonfinite;  // lowest index of such a body
	int press[2];         // 1 if some body is deep in a static body; in a kinematic body
	int continuous_items; // items of the kernel continuous: bodies, or parts of bodies, that moved far
	int held;             // bodies that continuous collision stopped
	int joint_moved;      // 1 if some joint got another spot; joint_updated clears it
	int joints_dirty;     // INT_MAX if some joint was created, was changed or broke since the last step, else 0
	int overflow_first, overflow; // joints without a color and a chain: first of them among the sorted keys, and number
	int joined;                   // pairs of bodies that joints or the user keep from touching
	int joint_events;             // joints whose force or torque exceeded a threshold in the step
	int touches_began, touches_ended, hits; // numbers of events of the step
	int waiting, refused, asked;            // contacts that are pending, refused, and listed for approval
	int holds;                              // INT_MAX if some contact is pending, else 0
	int moved_bodies;                       // bodies whose pose differs from the last one that the user read
	int fault; // code of a device that failed during a run; its backend reads it with the other counters
} Counters;

typedef struct // one entry of the list that a backend executes in order
{
	int kernel_id;  // KERNEL_* or PRIMITIVE_*
	int begin, end; // range of items
	int count;      // index in Counters of an upper bound of end, or -1
	int argument;   // argument of the kernel
} Run;

typedef struct
{
#define X(type, name, per, role) GLOBAL type* name;
#include "pools/pools.def"
#undef X
	Step step;
	int argument;
} Pools;

#endif
