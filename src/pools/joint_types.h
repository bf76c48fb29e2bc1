// SPDX-License-Identifier: MIT
// joint_types.h -- declares the data of joints: flags, modes, samples of paths, and results that the user reads.
#ifndef JOINT_TYPES_H
#define JOINT_TYPES_H
#include "dialect/dialect.h"

// Bits of the pool joint_flags. A hash contains all but JOINT_RECHAINED.
typedef int JointFlags;
#define JOINT_THERE     1    // the slot contains a joint
#define JOINT_ACTIVE    2    // both bodies are enabled, and at least one can move
#define JOINT_RESTARTS  4    // the constraint must end and begin again
#define JOINT_BROKEN    8    // the joint broke
#define JOINT_COLLIDES  16   // the two bodies may touch each other
#define JOINT_CAN_BREAK 32   // the joint breaks when its force or torque exceeds a threshold
#define JOINT_ACTS      64   // the joint has a lock, a limit, a spring or a motor
#define JOINT_NEW       128  // the slot contains a new joint
#define JOINT_STIRS     1024 // an input of a batch changed the joint; channel_stir clears this
#define JOINT_ASLEEP    512  // has no constraint because a body sleeps; its impulses are kept
#define JOINT_RECHAINED 2048 // it entered or left a chain: must end and begin again; a refused step may set it
#define JOINT_SEEKS     256  // flag of an edit: a body or a frame was placed, so the whole path must be searched

// masks of reasons to end and begin again, and of the bits that an edit of a joint leaves as they are
#define JOINT_BEGINS_AGAIN (JOINT_RESTARTS | JOINT_RECHAINED)
#define JOINT_KEPT_BITS    (JOINT_BROKEN | JOINT_BEGINS_AGAIN | JOINT_NEW | JOINT_ASLEEP)

// Bits of JointData.modes: four for each coordinate k, then others.
#define JOINT_LOCKED(k)  (1 << (4 * (k)))
#define JOINT_LIMITED(k) (2 << (4 * (k)))
#define JOINT_SPRING(k)  (4 << (4 * (k)))
#define JOINT_MOTOR(k)   (8 << (4 * (k)))
// mask of the parts of a coordinate for which whole turns count
#define JOINT_COUNTED(k)    (JOINT_LOCKED(k) | JOINT_LIMITED(k) | JOINT_SPRING(k))
#define JOINT_HAS_DRIVES(k) (JOINT_LIMITED(k) | JOINT_SPRING(k) | JOINT_MOTOR(k))
#define JOINT_EXTRAS        0xeee           // mask of all limits, springs and motors
#define JOINT_RADIAL        0x1000          // the axis lies along the line between the two anchors
#define JOINT_SOFT(k)       (0x2000 << (k)) // the lock of coordinate k is soft
#define JOINT_SPRINGS       0xe444          // mask of all springs and soft locks
#define JOINT_TURNS         0x10000         // the axis turns with body a
#define JOINT_COUPLED       0x20000         // a gear or a pulley: JOINT_ALONG is the coordinate of the coupling

// Measure of a coupling at side 0 (body a) or 1 (body b). JOINT_SLIDES: a translation; JOINT_HOISTS: a distance;
// neither: an angle.
#define JOINT_SLIDES(side) (0x40000 << (side))
#define JOINT_HOISTS(side) (0x100000 << (side))
#define JOINT_LINEAR(side) (JOINT_SLIDES(side) | JOINT_HOISTS(side))
#define JOINT_ELLIPTIC     0x400000 // the forces along and across have a common limit for springs, and one for motors
#define JOINT_RAILED       0x800000 // the axis is the tangent of a path at anchor b

// Coordinates of frame b in frame a.
#define JOINT_ALONG       0
#define JOINT_ACROSS      1
#define JOINT_ANGLE       2
#define JOINT_COORDINATES 3

typedef struct // 16 bytes: the lock of a coordinate; the target is in m or rad
{
	float target;       // value at which a lock holds the coordinate, or to which a spring pulls the coordinate
	float hertz, ratio; // frequency and damping ratio of a soft lock; if 0 Hz, those of the joint are used
	float unused;
} JointLock;

typedef struct // 32 bytes: limits, spring and motor of a coordinate, in m or rad, N or N m
{
	float lower, upper;
	float spring_hertz, spring_ratio, spring_least, spring_most;
	float speed, motor_most;
} JointDriveData;

// Offsets of the members of JointData, in rows of four floats.
#define JOINT_QUADS       16
#define JOINT_AT_MODES    0
#define JOINT_AT_FRAME(s) (1 + (s))
#define JOINT_AT_HERTZ    3
#define JOINT_AT_LOCK(k)  (4 + (k))
#define JOINT_AT_BASE(s)  (7 + (s))
#define JOINT_AT_DRIVE(k) (9 + 2 * (k))

typedef struct // 256 bytes; most joints need only the first half
{
	int body_a, body_b;            // indices of the bodies; 0 is the world
	float modes;                   // JOINT_* bits, as a float
	float gear_ratio;              // ratio of a coupling
	Float4 frame[2];               // joint frames in the frames of the bodies: x, y (m), cos, sin
	float hertz, ratio;            // frequency and damping ratio of rigid locks and of limits
	float most_force, most_torque; // N, N m: thresholds above which the joint is reported or breaks
	JointLock lock[JOINT_COORDINATES];
	Float4 base[2]; // poses in the world, from which a coupling measures the motions of its two frames
	JointDriveData drive[JOINT_COORDINATES];
	// Start values. Coupling: its angles become the nearest to near[0] and near[1], rad. Path: the search of the
	// nearest point starts at the arc length near[0], m.
	float near[2];
	float path_first, path_segments; // index of the path's first sample; number of samples minus 1
} JointData;

typedef struct // 32 bytes: a sample of a path, in its frame; the last sample of a closed path equals the first one
{
	float x, y, tangent_x, tangent_y; // position, m; unit tangent
	float along;                      // m: arc length from the start of the path
	float length;                     // m: length of the curve to the next sample; 0 for the last one of an open path
	float bend;                       // 1/m: curvature, positive to the left
	float unused;
} PathSample;

typedef struct // 272 bytes: a created or changed joint; `spot` as in the pool joint_spot
{
	int slot, flags, spot, unused;
	JointData data;
} JointEdit;

typedef struct // 48 bytes: the state of a joint that the user reads
{
	float value[3], speed[3]; // coordinates (m, m, rad) and their speeds (m/s, m/s, rad/s)
	float force_x, force_y;   // N: force on body b
	float torque;             // N m: torque on body b
	int broken;
	float unused[2];
} JointState;

typedef struct // 16 bytes: a joint whose force or torque exceeded a threshold
{
	int slot;
	float force, torque; // N, N m: maximum values in the step
	int broken;
} JointEvent;

#endif
