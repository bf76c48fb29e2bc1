// SPDX-License-Identifier: MIT
// pools.h -- the types of pools.def, for C and OpenCL C alike.
#ifndef POOLS_H
#define POOLS_H
#include "dialect/dialect.h"
#include "pools/query_types.h"

// ranges of constraints and bodies are padded to a multiple of this, so that every number of lanes divides them
#define MAX_LANES 16
// each color of the constraints is padded to a multiple of this, so that no group of lanes of a GPU spans two colors
#define COLOR_PADDING 32

// No two constraints of a color from 0 to COLORS - 1 share a body that can move; color COLORS is that of the spokes, the
// contacts of hubs. The pool color_mask has one bit per color: more colors would need a wider mask.
#define COLORS     63
#define COLOR_NONE (-1)
#define COLOR_MASK 0x7fffffffffffffffUL // a body with all colors taken

// bits of a color as a sorting key, without hubs
#define COLOR_BITS 7

// A body with more contacts is a hub. Two bodies that are not hubs have at least one common free color, because each has
// at most 31 other contacts.
#define HUB_CONTACTS 32

// Weight of a contact with a belt that runs back, in the pool belts. The counts of static bodies may exceed it, but only those
// of bodies that move are read.
#define BELT_BACK 65536

// A pass solves hubs in so many turns, by their numbers, so that hubs that touch are mostly solved one after the other.
#define HUB_COLORS 4

// A key of light ends: body from bit 32 on, turn of the hub from this bit on, number of the spoke below.
#define HUB_KEY_COLOR 30

// Coloring rounds before the host checks whether contacts are left. Even, because rounds alternate between two lists.
#define MAX_ROUNDS 64

// arity of the trees: the boxes of 8 children are 128 bytes, a cache line of a GPU
#define ARITY      8
#define ARITY_BITS 3
#define MAX_LEVELS 8 // the traversal has a 64-bit stack of 8 bits each: 8^8 = 16.7 million leaves

// Sorting the leaves of a tree costs about as much as this many visits of nodes per leaf.
#define ORDER_VISITS 16
#define OUTLIER_UNIT 64 // of Counters.strayed: 16.7 million leaves cannot overflow it

#define HASH_SUMS 1024

// In a world of fewer collidables the rows fit a CPU's second-level cache, and are not prefetched.
#define FETCH_COLLIDABLES 8192

// Items of broad and narrow phase in a chunk of a CPU worker; chunks begin at a multiple of it.
#define CHUNK_ITEMS 64

#define MAX_CORNERS 8 // of a core

// contacts begin at this separation, so that they are in place before bodies meet: four times the slop
#define LINEAR_SLOP          0.005f
#define SPECULATIVE_DISTANCE 0.02f

// of a body's thickness: how far it may go in a step before guard tests its path
#define CONTINUOUS_TRAVEL 0.2f
#define CONTINUOUS_CROSS  1.0f // the same where only what moves may be in its way: it must get past the middle of both
// kinematic bodies that guard compares a path with, before it looks which of them are near
#define KINEMATIC_FEW 8
// m: what is so deep in something kinematic, or static, is pressed by it, or against it
#define PRESS_FROM  2.0e-5f
#define PRESS_START 0.0001f // and so deep in something static it may be pressed
// m: a joint whose anchors are so far from each other drags a body that cannot follow
#define PRESS_GAP 0.01f
// m: no body gets deeper than that in something static into which something kinematic presses it. With less, the small overlap at which
// contacts hold a load is none.
#define PRESS_MOST 0.015f
// bits of the argument of its stages: the layout of the constraints may have changed; it is not the first round
#define PRESS_MAY_WAIT 1
#define PRESS_AGAIN    2
// fewest collidables of a body per work-item of guard, and most work-items per body
#define CONTINUOUS_SHARE 2
#define CONTINUOUS_PARTS 64

// Most bodies, collidables or attributes of a world: the range of the indices in trees.
#define MAX_ITEMS    (1 << 24)
#define MAX_CONTACTS (8 * MAX_ITEMS)

// an empty box overlaps nothing
#define EMPTY_LOW  1.0e30f
#define EMPTY_HIGH (-1.0e30f)

#define NO_PAIR (~(Word64)0) // behind all pairs of bodies

// separation of a missing point: so large that no impulse ever arises
#define NO_POINT 1.0e6f

// of a collidable: what happens to it is listed for the user
#define REPORT_TOUCHES  1u // its touches begin and end
#define REPORT_HITS     2u // it hits something, or is hit
#define REPORT_APPROVAL 4u // what it begins to touch waits for an answer

// of a collidable that is a sensor: what it sees; in the same word
#define SENSOR_MOVING  0x100u // what belongs to dynamic and kinematic bodies
#define SENSOR_STATIC  0x200u // to static ones, or to none
#define SENSOR_SENSORS 0x400u // other sensors
#define SENSOR_SHIFT   8
#define SENSOR_BITS    (SENSOR_MOVING | SENSOR_STATIC | SENSOR_SENSORS)

// bits of the pool moved
#define COLLIDABLE_NEW_BOX 1 // its box differs from old_box
#define COLLIDABLE_FAST    2 // it may go further in this step than the speculative distance covers
#define COLLIDABLE_MOVING  4 // it is not at rest in this step
// m: thinner bodies have finer tolerances. Twice the speculative distance
#define GRAIN_SIZE (2.0f * SPECULATIVE_DISTANCE)
// Each of these is set for a dynamic collidable that is thinner than so many halves of GRAIN_SIZE. Of a pair, the tolerances of
// contacts are halved once for each that either has: they would exceed the smaller body.
#define COLLIDABLE_GRAIN 8 // the first one
#define GRAIN_LEVELS     5
// The same of its reach, for the distance from which on a pair has points: a long thin body needs those of both ends.
#define COLLIDABLE_REACH  (COLLIDABLE_GRAIN << GRAIN_LEVELS)
#define COLLIDABLE_GRAINS (COLLIDABLE_GRAIN * ((1 << 2 * GRAIN_LEVELS) - 1))

// kinds of collidables
#define KIND_DEAD      0
#define KIND_STATIC    1
#define KIND_KINEMATIC 2
#define KIND_DYNAMIC   3
#define KIND_FREE      4 // without a body
#define KIND_SENSOR    8 // added to the kind of a sensor

// a contact with something kinematic in the pool fixed_contacts, where one with something static is 1
#define KINEMATIC_CONTACT         65536
#define STATIC_CONTACTS(fixed)    ((fixed) & (KINEMATIC_CONTACT - 1))
#define KINEMATIC_CONTACTS(fixed) ((Word)(fixed) / KINEMATIC_CONTACT)

// contact_flags
#define CONTACT_COUNT    3u    // mask of the number of points
#define CONTACT_FRESH    4u    // created in this step
#define CONTACT_DETECTED 8u    // gets no impulses: one side has no body
#define CONTACT_TOUCHING 16u   // has points
#define CONTACT_JOINED   8192u // a joint keeps the two bodies from touching
#define CONTACT_REPORT   14    // the REPORT_* bits of its collidables, from this bit on
#define CONTACT_REPORTS  ((REPORT_TOUCHES | REPORT_HITS) << CONTACT_REPORT)
#define CONTACT_TOUCHED  65536u  // its touch began, and will end
#define CONTACT_PASSES   131072u // a side of it is a one-way platform, which lets the other one through
#define CONTACT_IGNORED  262144u // its materials ignore each other
// of a contact about which the user is asked first
#define CONTACT_PENDING   524288u  // gets no impulses yet
#define CONTACT_WAITED    1048576u // the user was asked in the last step
#define CONTACT_REFUSED   2097152u // the answer was no, or none
#define CONTACT_APPROVED  4194304u // the answer was yes: it acts until the two part
#define CONTACT_APPROVALS (CONTACT_PENDING | CONTACT_WAITED | CONTACT_REFUSED | CONTACT_APPROVED)
#define CONTACT_HIGH      8388608u // it passes, but was higher than its platform, and may be held as if it were new
// a side of it was static, or kinematic, when it was created
#define CONTACT_STATIC    16777216u
#define CONTACT_KINEMATIC 33554432u
#define CONTACT_FIXED     (CONTACT_STATIC | CONTACT_KINEMATIC)
#define CONTACT_SUNK      67108864u // contact_sunk found in this step how deep its collidables are in a platform
#define CONTACT_APART     (CONTACT_JOINED | CONTACT_PASSES | CONTACT_IGNORED) // has no points, whatever the poses
#define CONTACT_LASTS                                                                                          \
	(CONTACT_DETECTED | CONTACT_REPORTS | CONTACT_TOUCHED | CONTACT_APPROVALS | CONTACT_HIGH | CONTACT_FIXED | \
	 CONTACT_SUNK) // bits that narrow_phase leaves alone
// within the narrow phase
#define CONTACT_LOOK 2048u // narrow_phase looks at it
#define CONTACT_ANEW 4096u // and finds its manifold anew
// in the same word: what the manifold does while bodies move on
#define MANIFOLD_ROLLS    32   // it follows its corners; otherwise it is held as it was found
#define MANIFOLD_CORNER1  64   // point 1 is at a corner of a, otherwise of b
#define MANIFOLD_CORNER2  128  // the same of point 2
#define MANIFOLD_TURNS_B  256  // the normal turns with b, otherwise with a
#define MANIFOLD_CORNERS  512  // the normal goes from a corner to a corner
#define MANIFOLD_OVERLAPS 1024 // some point overlapped

typedef struct // 160 bytes
{
	Float2 vertices[8]; // m, counter-clockwise
	Float2 normals[8];  // outward, of the edge from vertex i to i + 1
	float radius;       // m
	int count;          // vertices: 1 circle, 2 capsule and segment, 3 to 8 polygon
	float friction, restitution, rolling_resistance;
	float tangent_speed; // m/s
	float margin;        // m: how much an enlarged box exceeds a tight one
	float reach;         // m: largest distance of a point from the origin
} Attribute;

typedef struct // 16 bytes: what rules say of an attribute
{
	float up_x, up_y; // of a one-way platform: unit vector in the frame of the shape to the side from which it is solid
	int one_way;      // 1 for such a platform
	int material;
} Rule;

#define MATERIALS 256

// bits of MaterialPair.sets
#define MATERIAL_FRICTION    1
#define MATERIAL_RESTITUTION 2
#define MATERIAL_SPEED       4
#define MATERIAL_IGNORED     8

typedef struct // 16 bytes: what a pair of materials does instead of what their attributes say
{
	float friction, restitution;
	float tangent_speed; // m/s, as in Attribute
	int sets;            // MATERIAL_* bits: which of these count
} MaterialPair;

// Place of the pair of materials low and high in the pool material_pair: those that have the same higher one lie side by side.
#define MATERIAL_PLACE(low, high) ((high) * ((high) + 1) / 2 + (low))

typedef struct // 16 bytes: what guard needs of a dynamic body
{
	int first;   // 1 + index of its first collidable, 0 for none
	int parts;   // work-items that share its collidables
	float way;   // m: CONTINUOUS_TRAVEL times the thickness of its thinnest collidable
	float reach; // m: no point of it is further from the center of mass
} ContinuousBody;

typedef struct // 32 bytes: how a body is pressed
{
	int way[2];         // in this step, from what is static, from what is kinematic: hops left and direction, 0 without
	int depth;          // bits of how deep it is pressed into something static, m
	int speed;          // bits of the speed of what presses it, or did, m/s
	int left;           // steps for which it gets no faster than that
	int tight;          // 1 if it is still deep in something
	float before, spun; // its own speed and spin when the step began, m/s, rad/s
} Press;

typedef struct // 24 bytes
{
	Word64 category, mask;
	int group;
	Word reports; // REPORT_* and SENSOR_* bits
} Filter;

typedef struct // 64 bytes: the points of a contact as they were found
{
	Float4
	    normal; // x, y from a to b in the frame of a, separations of the points (m), NO_POINT for one that is not there
	Float4 on_a;     // points 1 and 2 in the frame of a, m
	Float4 relative; // pose of b in the frame of a then: x, y (m), cos, sin
	Float4 then; // rotation of a in the world then: cos, sin; reach of a; for how far a shift it is kept, negative for
	             // one of poses still to come, m
} LocalManifold;

typedef struct // 32 bytes: one sector
{
	float x, y, c, s;         // world pose
	float center_x, center_y; // from here to the body's center of mass, world axes, m
	int attribute, body;
} WorldShape;

// The rows of constraints, of src/constraints/: blocks of MAX_LANES constraints, one row per component. So a wide pass
// reads the rows of one contiguous block, and a GPU finds all components of a constraint from one address instead of
// seventeen. And the values that are kept while the rows are laid out again.
#define CONSTRAINT_KIND(kind, Kind, KIND)         \
	typedef struct Kind##Rows Kind##Rows;         \
	typedef struct Kind##RareRows Kind##RareRows; \
	typedef struct Kind##Kept Kind##Kept;         \
	typedef struct Kind##RareKept Kind##RareKept;
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

typedef struct // 96 bytes: a contact, as reported to the user
{
	Int2 pair, feature;
	Word flags;
	int color;
	float normal_x, normal_y;       // from a to b
	Float4 point;                   // points 1 and 2, x, y, m
	Float4 impulse;                 // normal 1, 2, tangent 1, 2, N s
	Float4 detail;                  // normal impulses of all substeps, N s, and approach speeds, m/s, of points 1 and 2
	float separation1, separation2; // m
	float unused[2];
} ContactReport;

typedef struct // what is common to the queries of a call
{
	Word64 category, mask;
	Word kinds;      // of Seen.kinds, those that are seen
	int all;         // category and mask have all bits
	int room;        // answers that the lists have room for
	int found;       // answers that were found, also without room for them
	float most;      // m: farther collidables are not near
	int skips;       // what a query begins inside of is not seen
	int rules;       // one-way platforms are seen from above only
	int bodies;      // slots of the pool body_generation that are in use
	Attribute shape; // of rays: a point
} QueryPlan;

typedef struct // MAX_LANES spokes; all but the first two are working data of a pass
{
	float parts[MAX_LANES];     // of the light end: one per spoke, and one for the hub that it may be
	float hub_parts[MAX_LANES]; // at the first spoke of a hub: parts of the hub
	float hub_x[MAX_LANES], hub_y[MAX_LANES], hub_w[MAX_LANES]; // at the first spoke: velocity of the hub's part
	float vx[MAX_LANES], vy[MAX_LANES], w[MAX_LANES];           // of the light end's part
	float inv_mass[MAX_LANES], inv_inertia[MAX_LANES];          // of the whole light end
	float gap1[MAX_LANES], gap2[MAX_LANES];                     // m
	float push_x[MAX_LANES], push_y[MAX_LANES], arm1[MAX_LANES], arm2[MAX_LANES]; // of a unit impulse on the hub
	float slope1[MAX_LANES], slope2[MAX_LANES];                               // m/s: of the energy along each impulse
	float mass1[MAX_LANES], mass2[MAX_LANES], cross[MAX_LANES];               // 1/kg: velocities by unit impulses
	float inverse1[MAX_LANES], inverse2[MAX_LANES], inverse[MAX_LANES];       // of mass1, of mass2, of the determinant
	float old1[MAX_LANES], old2[MAX_LANES], new1[MAX_LANES], new2[MAX_LANES]; // N s
	float limit1[MAX_LANES], limit2[MAX_LANES];
} Spokes;

// a component of spoke k of the pools p
#define spoke_at(p, component, k) ((p)->spokes[(k) / MAX_LANES].component[(k) % MAX_LANES])

// bits of joint_flags
#define JOINT_THERE     1   // the slot holds a joint
#define JOINT_ACTIVE    2   // both bodies are enabled, at least one of them moves
#define JOINT_RESTARTS  4   // its constraint has to start anew
#define JOINT_BROKEN    8   // it broke
#define JOINT_COLLIDES  16  // its bodies may touch each other
#define JOINT_CAN_BREAK 32  // it breaks when its force or torque exceeds its threshold
#define JOINT_ACTS      64  // it has something to solve: a lock, a limit, a spring or a motor
#define JOINT_NEW       128 // the slot holds another joint than before
#define JOINT_SEEKS     256 // of an edit: a body or a frame was placed, so another part of its path may be nearer

// JointData.modes: a whole number, of four bits for each coordinate, and more
#define JOINT_LOCKED(k)     (1 << (4 * (k)))
#define JOINT_LIMITED(k)    (2 << (4 * (k)))
#define JOINT_SPRING(k)     (4 << (4 * (k)))
#define JOINT_MOTOR(k)      (8 << (4 * (k)))
#define JOINT_HAS_DRIVES(k) (JOINT_LIMITED(k) | JOINT_SPRING(k) | JOINT_MOTOR(k))
#define JOINT_EXTRAS        0xeee           // limits, springs and motors
#define JOINT_RADIAL        0x1000          // its axis lies along the line between the two anchors
#define JOINT_SOFT(k)       (0x2000 << (k)) // its lock is a spring
#define JOINT_SPRINGS       0xe444          // springs and soft locks
#define JOINT_TURNS         0x10000         // its axis turns with body a
#define JOINT_COUPLED       0x20000         // it is a gear or a pulley, whose coordinate along is that of a coupling

// what a coupling measures of a side, 0 for a: a translation or a distance, else an angle
#define JOINT_SLIDES(side) (0x40000 << (side))
#define JOINT_HOISTS(side) (0x100000 << (side))
#define JOINT_LINEAR(side) (JOINT_SLIDES(side) | JOINT_HOISTS(side))
#define JOINT_ELLIPTIC     0x400000 // springs and motors along and across are bounded together
#define JOINT_RAILED       0x800000 // its axis is the tangent of a path, where anchor b is

// coordinates of frame b in frame a
#define JOINT_ALONG       0
#define JOINT_ACROSS      1
#define JOINT_ANGLE       2
#define JOINT_COORDINATES 3

typedef struct // 16 bytes: the lock of a coordinate, in m or rad
{
	float target;       // at which a lock holds it, to which a spring pulls it
	float hertz, ratio; // 0 Hz: as stiff as the joint
	float unused;
} JointLock;

typedef struct // 32 bytes: limits, spring and motor of a coordinate, in m or rad, N or N m
{
	float lower, upper;
	float spring_hertz, spring_ratio, spring_least, spring_most;
	float speed, motor_most;
} JointDriveData;

// places in JointData, in rows of four floats
#define JOINT_QUADS       16
#define JOINT_AT_MODES    0
#define JOINT_AT_FRAME(s) (1 + (s))
#define JOINT_AT_HERTZ    3
#define JOINT_AT_LOCK(k)  (4 + (k))
#define JOINT_AT_BASE(s)  (7 + (s))
#define JOINT_AT_DRIVE(k) (9 + 2 * (k))

typedef struct // 256 bytes, of which every joint needs the first half
{
	int body_a, body_b;            // 0 for the world
	float modes;                   // JOINT_* bits, as a number
	float gear_ratio;              // of a coupling
	Float4 frame[2];               // in the frames of the bodies: x, y (m), cos, sin
	float hertz, ratio;            // of rigid locks and limits
	float most_force, most_torque; // N, N m: thresholds
	JointLock lock[JOINT_COORDINATES];
	Float4 base[2]; // of a coupling, in the world
	JointDriveData drive[JOINT_COORDINATES];
	float near[2]; // rad: what angles of a coupling were nearest to when it began; m: where the search on a path begins
	float path_first, path_segments; // of a path: its first sample, and samples but the last
} JointData;

typedef struct // 32 bytes: a sample of a path, in the frame of the path. The last one of a closed path is the first one again
{
	float x, y, tangent_x, tangent_y; // m; of length 1
	float along;                      // m: from the start of the path
	float length;                     // m: of the curve up to the next sample; 0 for the last one of an open path
	float bend;                       // 1/m: curvature, positive to the left
	float unused;
} PathSample;

typedef struct // 272 bytes: a joint as the user wants it
{
	int slot, flags, spot, unused;
	JointData data;
} JointEdit;

// Spots of a chain: its joints are in rows, joint k in row k mod R, where R is a power of two. The even rows come first, then the
// odd ones. Joints of one half have no bodies in common, so that a wide pass takes a block of them, and the neighbors of a block
// are a block, but those of a row's ends. Or chains of similar lengths lie side by side: joints k of LANES chains are one block,
// or a part of one; then R is 2, and joint k + 2 is MAX_LANES spots behind joint k.
typedef struct // 32 bytes: a chain, or some side by side
{
	int first;  // spot of joint 0
	int count;  // joints of the longest one; nodes of a branch
	int odds;   // spots from joint 0 to joint 1; of a branch, its node 0 in the pool
	int stride; // spots between neighbors in a row: 1, or MAX_LANES
	int length; // joints of a row, with inert ones at its end
	int bits;   // of the number of rows, at least 1
	int parts;  // ranges in the same blocks, from this one on, which are an item of a pass; 0 for the others of them
	int item;   // where the range is with which item i of a pass begins, for range i
} ChainRange;

// The spot of joint k of a ChainRange.
#define CHAIN_SPOT(c, k)                                                                           \
	((c)->first + ((k)&1) * (c)->odds + (((k) >> 1) & ((1 << (c)->bits >> 1) - 1)) * (c)->length + \
	 ((k) >> (c)->bits) * (c)->stride)

typedef struct // 32 bytes: a body of a branch, and its joint toward the root. Nodes are in the order of their distance from the root
{
	int body;         // its index
	int side;         // of the body at the joint: 0 for a, 1 for b
	int up;           // the node that it hangs on, from the first of the branch on; -1 for none that moves
	int first, count; // nodes that hang on it
	int begin, end;   // nodes as far from the root
	int unused;
} BranchNode;

typedef struct // MAX_LANES joints in the systems of their chains: working data of a pass
{
	float d[6][MAX_LANES];    // diagonal block 00, 01, 02, 11, 12, 22; when it is eliminated, the inverse
	float l[9][MAX_LANES];    // block that couples a joint with the one before it
	float m[9][MAX_LANES];    // block that couples one behind with it, at this level
	float r[3][MAX_LANES];    // right side
	float x[3][MAX_LANES];    // solution
	float pose[6][MAX_LANES]; // the first axis; levers of both axes on a, and on b
	int body_a[MAX_LANES], body_b[MAX_LANES];    // indices of its bodies
	float locks[MAX_LANES], holds[MAX_LANES];    // bits of coordinates: locked; and with a yield
	float side[MAX_LANES], other[MAX_LANES];     // of the body shared with the joint before: 0 for a, 1 for b; there
	float inv_mass[MAX_LANES], turns[MAX_LANES]; // 1/kg, 1/(kg m^2): of the shared body; 0 for none
	float tension[2][MAX_LANES];                 // kg m^2: what its pull adds to the inertia of its bodies
	float own_a[MAX_LANES], own_b[MAX_LANES];    // 1/(kg m^2): inverse inertias of its bodies
	float step_a[MAX_LANES], step_b[MAX_LANES];  // the same for the step, with the tension
	float slack[MAX_LANES];                      // 1/(kg m^2): softness of the damping of a free angle; 0 for none
} ChainBlock;

// a component of the joint at a spot
#define chain_at(p, component, spot) ((p)->chain_joints[(spot) / MAX_LANES].component[(spot) % MAX_LANES])

typedef struct // 48 bytes: what the user reads of a joint
{
	float value[3], speed[3]; // of the coordinates: m, m, rad; m/s, m/s, rad/s
	float force_x, force_y;   // N: on body b
	float torque;             // N m
	int broken;
	float unused[2];
} JointState;

typedef struct // 16 bytes
{
	int slot;
	float force, torque; // N, N m: the largest of the step
	int broken;
} JointEvent;

typedef struct // 32 bytes: one sector, gathered at random by the solver
{
	float vx, vy, w;   // m/s, rad/s
	float inv_mass;    // 1/kg, zero for static and kinematic bodies, which are never written
	float dx, dy, da;  // m, rad: motion since the step began
	float inv_inertia; // 1/(kg m^2)
} BodyState;

typedef struct // 32 bytes
{
	float fx, fy, torque;                  // N, N m; finalize clears them
	float gravity_scale;                   // 0 for static and kinematic bodies
	float linear_damping, angular_damping; // 1/s
	float free_x, free_y;                  // 1, or 0 where a motion lock holds
} Motion;

typedef struct // 16 bytes: the velocity of a disabled body
{
	float vx, vy, w;
	float stored; // 1, or 0 for a body that is enabled
} StoredVelocity;

// kinds of fields, as scree_field_type
#define FIELD_UNIFORM  0
#define FIELD_RADIAL   1
#define FIELD_VORTEX   2
#define FIELD_DRAG     3
#define FIELD_WIND     4 // this one and the next act on shapes, the others on bodies
#define FIELD_BUOYANCY 5

// Of more fields, boxes around ARITY boxes are tested first.
#define FIELD_FEW (ARITY * ARITY)

// how a radial field and a vortex fall off, as scree_field_falloff
#define FALLOFF_CONSTANT       0
#define FALLOFF_LINEAR         1
#define FALLOFF_INVERSE        2
#define FALLOFF_INVERSE_SQUARE 3

typedef struct // 288 bytes
{
	Attribute
	    shape;   // of its region; only corners, normals, radius and count. count is 0 for a field that is everywhere
	Float4 pose; // of the region in the frame of the body, or in the world: x, y (m), cos, sin
	Word64 category, mask; // of what it acts on
	int all;               // category and mask have all bits
	int body;              // -1 for none
	int kind, falloff;     // FIELD_*, FALLOFF_*
	// in the frame of the region
	float acceleration_x, acceleration_y; // m/s^2
	float force_x, force_y;               // N
	float velocity_x, velocity_y;         // m/s: of the medium
	float strength;                       // m/s^2
	float radius, softening;              // m
	float density;                        // kg/m^2: of the medium
	float drag, lift;                     // coefficients of a shape in the medium
	float linear_drag, quadratic_drag;    // kg/s, kg/m; of buoyancy linear_drag is for 1 m^2
	float spin_drag, spin_drag_quadratic; // N m s, N m s^2
	float unused[4];
} Field;

typedef struct // 48 bytes: a field in the step
{
	Float4 pose;              // of its region: x, y (m), cos, sin
	float center_x, center_y; // m: center of mass of its body, from there on
	float vx, vy, w;          // m/s, rad/s: of that body
	float unused[3];
} FieldSample;

typedef struct // 48 bytes: what acts on a body, about its center of mass
{
	float fx, fy, torque;              // N, N m: what does not depend on its velocity
	float drag_x, drag_y, drag_torque; // N, N m: what brakes it
	float rate, rate_x, rate_y,
	    rate_w; // kg/s, kg m/s, kg m^2/s: sums of k, k x, k y, k (x^2 + y^2) over drags k at points x, y
	float unused[2];
} FieldForce;

typedef struct // 32 bytes: a change that the user made between steps
{
	int kind;  // COMMAND_*
	int index; // body, or collidable
	int whole[2];
	Float4 value;
} Command;

// Command.kind, and what value and whole hold. Kinds from COMMAND_PLACE on name a collidable, the others a body; for
// kinds below COMMAND_BODY, whole[1] is 1 if that body is disabled.
#define COMMAND_FORCE           0  // x, y: N
#define COMMAND_FORCE_AT        1  // force x, y, world point x, y
#define COMMAND_TORQUE          2  // x: N m
#define COMMAND_IMPULSE         3  // x, y: N s
#define COMMAND_IMPULSE_AT      4  // impulse x, y, world point x, y
#define COMMAND_ANGULAR_IMPULSE 5  // x: N m s
#define COMMAND_VELOCITY        6  // linear x, y, angular
#define COMMAND_POSE            7  // of the body's origin: x, y, cos, sin
#define COMMAND_MASS            8  // inverse mass, inverse inertia, local center x, y: the origin stays where it is
#define COMMAND_MOTION          9  // gravity scale, linear damping, angular damping; whole[0]: locks
#define COMMAND_LINEAR_VELOCITY 10 // x, y: m/s; the spin stays
#define COMMAND_SPIN            11 // x: rad/s; the linear velocity stays
#define COMMAND_BODY \
	12 // a new row, without mass: center of mass x, y, cos, sin; whole: bits of that in the body's frame
#define COMMAND_CONTINUOUS 13 // ContinuousBody: whole first, parts; x way, y reach
#define COMMAND_ENABLED    14 // whole[0]: 1, or 0 for a body that takes no part from now on
#define COMMAND_TARGET     15 // pose of the origin x, y, cos, sin at the end of the step; whole[0]: locks
#define COMMAND_ARRIVE     16 // the same at the end of that step: moves the body there, and stops it
#define COMMAND_PLACE      17 // a collidable without a body: x, y, cos, sin
#define COMMAND_COLLIDABLE 18 // local pose x, y, cos, sin; whole: attribute, body. Its contacts end, new ones begin
#define COMMAND_ATTRIBUTE  19 // whole[0]: another attribute of the same shape
#define COMMAND_FILTER     20 // the bits of category and mask; whole: group; kind, and REPORT_* bits from bit 8 on
#define COMMAND_NEXT       21 // whole[0]: 1 + index of the body's next collidable, 0 for none
#define COMMAND_REPORTS    22 // whole[0]: REPORT_* bits

// lists of events
#define EVENT_TOUCH_BEGAN 0
#define EVENT_TOUCH_ENDED 1
#define EVENT_HIT         2
#define EVENT_APPROVALS   3
#define EVENT_LISTS       4

typedef struct // one tree of the broad phase, as the host sees it
{
	int leaf_begin;        // first item in the leaf pool
	int leaves;            // leaves in use
	int top;               // highest level, the first with at most ARITY nodes; level 0 are the leaves
	int begin[MAX_LEVELS]; // first item of each level in the pool node_box
	int count[MAX_LEVELS]; // nodes of each level; the pool is padded with empty boxes to a multiple of ARITY
} Tree;

typedef struct // stiffness of a contact: Erin Catto, Soft Constraints, GDC 2011
{
	float bias_rate, mass_scale, impulse_scale;
	float firm, depth; // bias_rate is larger by this share of itself up to this overlap, m
} Softness;

// Kinds of constraints. An edge is a constraint of any kind: the kind in the bits above its slot.
enum
{
#define CONSTRAINT_KIND(kind, Kind, KIND) CONSTRAINT_##KIND,
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	CONSTRAINT_KINDS
};
#define EDGE_KIND 27 // bits of a slot: MAX_CONTACTS of them

typedef struct // the kinematic bodies of a world that has no more; in Step, an index that is not constant would put that on a GPU's stack
{
	int body[KINEMATIC_FEW];
} Kinematics;

typedef struct // constants of one step, passed by value to every stage
{
	float dt, h, inv_h; // s, substep s, 1/s
	float gravity_x, gravity_y;
	float max_speed, max_spin; // m/s, rad/s
	float push_speed;          // m/s
	float restitution_threshold;
	float fall;             // m: how far gravity may move what rests, in a step, and more
	Softness pair, fixed;   // softness of contacts: between bodies that can move; with one that cannot
	float h_ratio;          // h over that of the last step that took time
	int has_rolling;        // some attribute has restitution, rolling resistance or tangent speed
	int belts;              // some attribute, or pair of materials, has a tangent speed
	int segments;           // some attribute is a segment
	int details;            // the user wants to know what contacts did in the step
	int reports;            // some collidable reports touches or hits
	int rules;              // some pair may be subject to a rule
	int material_pairs;     // rows of the pool material_pair
	int excluded;           // rows of the pool excluded
	int asks;               // some collidable asks
	int request_again;      // what the user was asked in the last step has no answer yet, and is asked again
	int allowed;            // rows of the pool allowed
	float hit_speed;        // m/s: slower approaches are no hits
	float hit_impulse;      // N s: nor are smaller impulses
	int bounces;            // some attribute has restitution
	int joints;             // there may be joints among the constraints
	int calm;               // bodies without contacts and forces go as their velocities say, within 5 mm
	int chain_places;       // spots of chains
	int has_drives;         // some joint has a limit, a spring, a motor or a threshold, is a coupling or follows a path
	int springs;            // some joint has a spring or a soft lock
	int couplings;          // some joint is a gear or a pulley
	int paths;              // some joint follows a path
	int kinematic;          // kinematic bodies
	int presses;            // there is something static, and kinematic bodies or joints with what does not move
	int round;              // some attribute has a radius
	int small;              // some dynamic collidable may be thinner than GRAIN_SIZE
	float continuous_way;   // m: lower bound of all ContinuousBody.way of the world
	float continuous_reach; // m: upper bound of all ContinuousBody.reach
	int collidables;        // slots in use
	int pair_capacity, contact_capacity;
	int place_capacity[CONSTRAINT_KINDS];
	int contact_limit; // most contacts that the world may have
	int traversal_nodes,
	    traversal_items; // nodes over leaves that a traversal visits before its rest is split among so many work-items
	int key_bits;        // bits of a collidable's index in a pair's key
} Step;

// Whether rare rows of contacts are used.
#define STEP_RARE(step) ((step).has_rolling | (step).details)

typedef struct // places of the constraints of a kind
{
	int begin[COLORS + 2]; // first place of each color; color COLORS is that of spokes
	int count[COLORS + 1]; // constraints of each color, padding not counted
	int first[COLORS + 2]; // of this step: first and behind the last of each color among the sorted keys
	int last[COLORS + 2];
} KindLayout;

// Counters on the device. All are ints, so that Run.count can name one by its position.
typedef struct
{
	// kept from step to step
#define CONSTRAINT_KIND(kind, Kind, KIND) int kind##s; // slots of the kind's pool up to the last one in use
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	int presses;                         // INT_MAX if something may be pressed, else 0
	int ways;                            // 1 if some contact hands a press on
	int belts;                           // 1 if a belt turned back since hubs were searched for
	int alive;                           // live contacts, and those released in the last step
	int touching;                        // contacts with a color, spokes included
	KindLayout layout[CONSTRAINT_KINDS]; // where constraints lie
	int hubs;                            // bodies solved with all of their contacts
	int split;                           // ends of spokes, if some body is split into parts, else 0
	int outliers[2]; // of each tree: nodes that a walk visits in vain because of boxes that jumped, times OUTLIER_UNIT
	// of this step
	int updated_boxes; // collidables whose enlarged box changed
	int changed;       // 1 if a constraint began or ended, so that a layout is due
	int kept;          // INT_MAX if the layout of the last step is valid; 0 if it changed or must not be used
	int refit;         // tree nodes to recompute: all if some box changed, else 0
	int jumped;        // tree nodes to check for boxes that jumped: all if some box did, else 0
	int order[2];      // of each tree: leaves to sort in this step, all or 0
	int traversals;    // walks that one work-item did not finish
	int rest;          // work-items that these are split among: all, or 0 if there are none
	int pairs;         // new pairs found, also without room for them; above the limit not all
	int over_limit;    // 1 for more contacts than a world may have: the rest of the step is skipped
	int sort_pairs;    // new pairs, or 0 without room for them
	int search;        // contact slots to search for free ones, plus one; 0 without new pairs
	int dead;          // free slots found
	int created;       // new contacts
	int needed;        // contact slots that the step needs
	int stalled;       // 1 if crowded or a buffer is too small: the rest is skipped; the host repeats the step
	int live;          // contact slots of the narrow phase
	int look;          // the same if it has to look at some, else 0
	int released;      // contacts whose boxes parted
	int began, ended;  // contacts that began and ceased to touch
	int gathered;      // contact slots to search for contacts of bodies that became hubs, else 0
	int entered;       // 1 when a contact became a spoke
	int uncolored[MAX_ROUNDS + 1]; // [r + 1]: contacts without a color after coloring round r
	int dirty[CONSTRAINT_KINDS];   // 1 when a constraint of the kind began or ended
	int arrange[CONSTRAINT_KINDS]; // slots of the kind to sort by color: 0 if none began or ended
	int arranged;                  // 1 if all that changed was laid out
	int penetration;               // bits of the deepest overlap, m
	int joint_gap;                 // bits of the widest gap of a joint, m
	int taut;             // 1 if the pull of some joint was large against the inertia of a body, until body_taut
	int nonfinite;        // bodies frozen because their state was not finite
	int first_nonfinite;  // lowest index of these
	int press[2];         // 1 if some body is deep in something static; in something kinematic
	int continuous_items; // items of continuous: bodies that went far; a body of many collidables has several
	int held;             // bodies that guard stopped before something static
	int joint_moved;      // 1 if some joint got another place among the chains, until joint_update
	int joints_dirty;     // INT_MAX if some joint was made, changed or broke since the last step, else 0
	int overflow_first, overflow; // among the sorted keys of joints those without a color and a chain begin; how many
	int joined;                   // pairs of bodies that joints or the user keep from touching
	int joint_events;             // joints whose force exceeded a threshold in the step
	int touches_began, touches_ended, hits; // of the step
	int waiting, refused, asked;            // contacts that wait, that were refused, that are listed
	int holds;                              // INT_MAX if some wait, else 0
	int moved_bodies;                       // bodies at other poses than the user was told
	int fault; // set by a device that failed during a run; its backend reads it with the other counters
} Counters;

typedef struct // one entry of a list that a backend executes in order
{
	int kernel_id;  // KERNEL_*, or PRIMITIVE_*
	int begin, end; // items
	int count;      // position in Counters of an upper bound of end, or -1
	int argument;   // of the stage
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
