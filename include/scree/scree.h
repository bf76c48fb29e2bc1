// SPDX-License-Identifier: MIT
// scree.h -- the public interface of Scree, a 2D rigid body physics engine with bit-identical results on CPU and GPU.
//
// This header is also the manual. The shortest program is examples/hello.c.
//
// Units are metres, kilograms, seconds and radians. Positive angles are counter-clockwise.
//
// Threads. Only one thread at a time may use a world. Different threads may use different worlds at the same time.
//
// Errors. Every function that can fail returns a scree_status. If it is not SCREE_OK, nothing has changed, except where
// noted, and scree_error() returns one sentence that names the argument and its value.
//
// Handles consist of an index and a generation. The all-zero handle is null. Functions refuse a handle whose object has
// been destroyed with SCREE_ERROR_STALE, but for bodies that a query ignores.
//
// Ownership. The library copies all arguments, except where noted. The caller owns every world and destroys it; a world
// owns everything in it.
//
// Changes (forces, velocities, poses, ...) are collected between steps and uploaded to the device as one batch. Reading
// anything back uploads pending changes first, so a read returns what was written.
//
// Versions. New members are added at the end of definitions and results. A definition therefore starts with its size,
// which its default function sets; functions that fill a result receive its size (see the end of this header). Programs
// and libraries of different versions work together; the library refuses unknown members that are set.
//
// Determinism. The same calls in the same order give the same scree_world_get_hash on every device, with any number of
// threads and lanes, and with every compiler that follows IEEE 754.
#ifndef SCREE_H
#define SCREE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(_WIN32) && defined(SCREE_SHARED)
#if defined(SCREE_BUILDING)
#define SCREE_API __declspec(dllexport)
#else
#define SCREE_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define SCREE_API __attribute__((visibility("default")))
#else
#define SCREE_API
#endif

#define SCREE_VERSION_MAJOR 0
#define SCREE_VERSION_MINOR 2
#define SCREE_VERSION_PATCH 0

// Maximum vertices of a convex polygon. The narrow phase clips in registers; a larger limit would slow down every pair.
#define SCREE_MAX_VERTICES 8

// Largest coordinate, in metres; larger ones are refused. The spacing of floats is 8 mm there.
#define SCREE_MAX_COORDINATE 100000.0f

// ---------------------------------------------------------------------------------------------------------------
// Errors, hooks and version
// ---------------------------------------------------------------------------------------------------------------

typedef enum scree_status
{
	SCREE_OK = 0,
	SCREE_ERROR_INVALID = 1,       // an argument is out of range; nothing changed
	SCREE_ERROR_STALE = 2,         // a handle is null, or its object was destroyed; nothing changed
	SCREE_ERROR_OUT_OF_MEMORY = 3, // host or device memory; nothing changed, except late in a step (scree_world_step)
	SCREE_ERROR_NO_DEVICE = 4,     // the requested device does not exist or is not bit-identical to the CPU
	SCREE_ERROR_DEVICE_FAILED = 5, // the driver reported an error; the world can only be destroyed
	SCREE_ERROR_NOT_SUPPORTED = 6, // the device does not support this operation; nothing changed
	SCREE_ERROR_CONTACT_LIMIT =
	    7, // scree_world_step: more contacts than scree_world_def.contact_limit; nothing changed
} scree_status;

// The message of the last failure on this thread, or an empty string. Valid until the next failing call.
SCREE_API const char* scree_error(void);

// The name of a status, "ok", "invalid", ...; never null.
SCREE_API const char* scree_status_name(scree_status status);

// "0.2.0": major, minor and patch
SCREE_API const char* scree_version(void);

typedef enum scree_log_level
{
	SCREE_LOG_INFO,
	SCREE_LOG_WARNING,
} scree_log_level;

// Process-wide hooks. A null member selects the default. Any thread that calls Scree may call the hooks, and so may the
// background thread that opens a GPU for a world with device "auto".
typedef struct scree_hooks
{
	void* (*allocate)(size_t bytes, size_t alignment, void* context); // alignment is a power of two; may return null
	void (*release)(void* memory, void* context);
	void (*log)(scree_log_level level, const char* sentence, void* context); // default: warnings to stderr
	void (*assert_failed)(const char* expression, const char* file, int line, void* context); // default: print, abort
	void* context;
} scree_hooks;

// Installs a copy of hooks; null restores the defaults. Fails with SCREE_ERROR_INVALID while a world exists, or if only
// one of allocate and release is set.
SCREE_API scree_status scree_hooks_set(const scree_hooks* hooks);

// Host memory that the library currently uses, in bytes.
SCREE_API size_t scree_memory(void);

// ---------------------------------------------------------------------------------------------------------------
// Small types
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_vec
{
	float x, y;
} scree_vec;

// A rotation as cosine and sine; c * c + s * s is 1.
typedef struct scree_rot
{
	float c, s;
} scree_rot;

typedef struct scree_pose
{
	scree_vec position; // m
	scree_rot rotation;
} scree_pose;

typedef struct scree_velocity
{
	scree_vec linear; // m/s, of the center of mass
	float angular;    // rad/s
} scree_velocity;

typedef struct scree_box
{
	scree_vec lower, upper;
} scree_box;

// The rotation by an angle in radians. Uses Scree's own polynomials, which give the same bits on every machine.
SCREE_API scree_rot scree_rot_make(float radians);

// The angle of a rotation, in [-pi, pi] radians, from Scree's own polynomial.
SCREE_API float scree_rot_get_angle(scree_rot rotation);

// ---------------------------------------------------------------------------------------------------------------
// Devices
// ---------------------------------------------------------------------------------------------------------------

typedef enum scree_sharing // how render rows get into an OpenGL buffer; the best way is last
{
	SCREE_SHARING_COPIED, // through host memory: scree_world_get_render_rows, then upload to the buffer
	SCREE_SHARING_MEMORY, // cl_khr_external_memory with file descriptors: scree_world_share_memory
	SCREE_SHARING_OPENGL, // cl_khr_gl_sharing: scree_world_share_opengl
} scree_sharing;

// "copied", "shared through external memory", "shared with OpenGL"
SCREE_API const char* scree_sharing_name(scree_sharing sharing);

typedef struct scree_device
{
	char name[128];        // valid as scree_world_def.device: "cpu", "opencl:NVIDIA H200"
	char driver[128];      // platform and driver version; for the CPU its widest lanes
	bool equal_bits;       // whether results are bit-identical to the CPU's
	char reason[192];      // if not, why, and what to do; otherwise empty
	int compute_units;     // CPU threads or OpenCL compute units
	uint64_t memory;       // bytes
	scree_sharing sharing; // the best way that its driver supports
	uint8_t uuid[16];      // device UUID as in OpenGL and Vulkan; zero if the driver does not report it
} scree_device;

// Lists the devices of this machine, the CPU first. Writes at most capacity entries (devices may be null if capacity is
// 0) and sets count to the total number. Without OpenCL, scree_opencl_hint tells what to install.
static inline scree_status scree_devices_get(scree_device* devices, int capacity, int* count);

// One sentence that tells what to install to get an OpenCL device, or an empty string if there is one.
SCREE_API const char* scree_opencl_hint(void);

// ---------------------------------------------------------------------------------------------------------------
// World
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_world scree_world;

typedef enum scree_window_system
{
	SCREE_WINDOW_EGL, // EGLContext, EGLDisplay
	SCREE_WINDOW_GLX, // GLXContext, Display*
	SCREE_WINDOW_WGL, // HGLRC, HDC
} scree_window_system;

typedef struct scree_opengl // an OpenGL context
{
	scree_window_system system;
	void *context, *display;
} scree_opengl;

typedef struct scree_world_def
{
	uint32_t size;           // set by scree_world_def_default
	scree_vec gravity;       // m/s^2, default (0, -10)
	const char* device;      // "auto" (default), "cpu", "opencl", "opencl:NAME" (NAME is any part of a device's name)
	int threads;             // CPU worker threads, 0 to 64; 0 (default): one per core
	int lanes;               // CPU SIMD lanes: 1, 4, 8 or 16; 0 (default): the widest that the processor supports
	bool allow_unequal_bits; // accept a device whose results are not bit-identical; default false
	bool timings;            // measure each stage (scree_world_get_timings); slows down a GPU slightly; default false
	// contact stiffness, Hz, 1e-3 to 1e6, default 40; limited to 1/6 of the substep rate; where contacts are deep, 3 % more, to 2/3 of the step rate
	float contact_hertz;
	float contact_damping_ratio; // 0 to 1e6, default 10
	float contact_push_speed;    // maximum speed that pushes a pair apart, m/s, 0 to SCREE_MAX_COORDINATE, default 3
	float restitution_threshold; // slower impacts do not bounce, m/s, >= 0, default 1
	float
	    max_speed; // limit at the end of a step, m/s, 1e-3 to SCREE_MAX_COORDINATE, default 400. Rotation is limited to pi
	               // radians per step and pi / 4 per substep
	const scree_opengl* opengl; // null (default), or the context for scree_world_share_opengl. The struct is copied;
	                            // the context must outlive the world
	int body_capacity;          // initial capacity, grows on demand; 0 (default): small
	int contact_capacity;       // the same for contacts
	int contact_limit;          // maximum number of contacts, 300 bytes each; a step that finds more fails with
	                            // SCREE_ERROR_CONTACT_LIMIT. 0 (default): 32 per collidable, but at least 2 million
	// Contacts report what they did in the last step: scree_contact.details. Costs up to 5 % of the solve and 36 bytes per
	// contact; changes no motion. Default false.
	bool contact_details;
	float hit_speed;   // slower approaches are no scree_hit, m/s, >= 0, default 1
	float hit_impulse; // nor are smaller impulses, N s, >= 0, default 0
} scree_world_def;

static inline scree_world_def scree_world_def_default(void);

// Creates a world. The caller owns *world and destroys it with scree_world_destroy. On failure *world is null.
//
// With device "auto" the world starts on the CPU. scree_world_step moves it to a GPU, and back, when steps are faster
// there, and logs both times (SCREE_LOG_INFO). A background thread opens the GPU once the world is large enough to gain
// from it. A GPU that fails, or whose results differ from the CPU's, is logged and not used. A move changes no bit of
// the world. docs/auto.md has the rules.
SCREE_API scree_status scree_world_create(const scree_world_def* def, scree_world** world);

// Destroys a world and everything in it. world may be null.
SCREE_API void scree_world_destroy(scree_world* world);

// Advances a world by dt seconds (1e-9 to 1, or 0) in 1 to 64 substeps. Typical values are 1/60 and 4. Based on Erin Catto,
// Solver2D, 2024; Macklin et al., Small Steps in Physics Simulation, 2019.
//
// A step of dt 0 only detects: contacts and overlaps begin and end at the current poses, so that they can be read as soon
// as a world was built or a body was placed, with scree_counters.penetration. Poses, velocities, forces, targets and the
// impulses of existing points stay; a new contact has no impulse. The step counts in scree_counters.steps, and
// scree_traffic is zero after it. It leaves the same bits on every device. Later steps differ in their bits from those
// without it, because boxes and contacts were updated at another time.
//
// The number of contacts grows with the square of the number of bodies in one place. If it exceeds
// scree_world_def.contact_limit, the step fails with SCREE_ERROR_CONTACT_LIMIT; the message names the most crowded place and
// the number of collidables there. If memory for the contacts runs out, the step fails with SCREE_ERROR_OUT_OF_MEMORY.
// In both cases nothing has changed; move bodies apart or destroy some, and step again.
//
// A later failure (the device fails, or has no memory left for the solver) cannot be undone. The error is sticky: from
// then on every call that uses the world returns the same status, and the world can only be destroyed.
SCREE_API scree_status scree_world_step(scree_world* world, float dt, int substeps);

// Gravity, m/s^2; components must be finite.
SCREE_API scree_status scree_world_set_gravity(scree_world* world, scree_vec gravity);
SCREE_API scree_status scree_world_get_gravity(const scree_world* world, scree_vec* gravity);

typedef struct scree_tuning // the members of scree_world_def of the same names
{
	uint32_t size; // set by scree_world_get_tuning
	float contact_hertz;
	float contact_damping_ratio;
	float contact_push_speed;
	float restitution_threshold;
	float max_speed;
} scree_tuning;

// Solver tuning; changes take effect with the next step. Get it, change members, set it. Units and ranges are those of
// scree_world_def.
static inline scree_status scree_world_get_tuning(const scree_world* world, scree_tuning* tuning);
SCREE_API scree_status scree_world_set_tuning(scree_world* world, const scree_tuning* tuning);

// The device on which the world currently runs, as in scree_device.name. The string is owned by the world and changes
// when the world moves.
SCREE_API const char* scree_world_get_device(const scree_world* world);

// Moves a world to another device between two steps. device is "cpu", "opencl" or "opencl:NAME" to stay there, or
// "auto" to let scree_world_step choose from now on. The world continues with the same bits: hash, handles, contacts,
// impulses and pending changes are kept. Threads, lanes, allow_unequal_bits and timings are those of its definition.
//
// A move opens the device (about 0.3 s for a GPU) and transfers about 1 kB per body; both devices hold the world
// meanwhile. On failure (SCREE_ERROR_NO_DEVICE, SCREE_ERROR_OUT_OF_MEMORY, ...) the world stays unchanged on its
// device. If that device fails while it is read, the error (SCREE_ERROR_DEVICE_FAILED) is sticky, as after
// scree_world_step.
SCREE_API scree_status scree_world_move(scree_world* world, const char* device);

// CPU threads and lanes in use; 0 on an OpenCL device.
SCREE_API int scree_world_get_threads(const scree_world* world);
SCREE_API int scree_world_get_lanes(const scree_world* world);

// A 64-bit hash of all simulated state. Worlds with equal state have equal hashes on every device.
SCREE_API scree_status scree_world_get_hash(scree_world* world, uint64_t* hash);

typedef struct scree_counters
{
	int bodies, dynamic_bodies;  // alive
	int collidables, attributes; // alive
	int contacts;                // pairs whose enlarged boxes overlap
	int touching;                // contacts with manifold points, speculative ones included
	int colors;                  // colors in use
	int spokes;                  // contacts of hubs (bodies with more than 32 contacts), which are solved together
	int updated_boxes;           // collidables whose enlarged box changed in the last step
	int new_contacts;            // contacts found in the last step
	int reallocations;           // buffer reallocations since the world was created
	int frozen_bodies; // bodies frozen in the last step because their state became infinite or NaN. No force, impulse or
	                   // ratio of masses is known to do that. A body that reaches 1e8 m stops there
	int stopped_bodies;    // bodies that were stopped in the last step because they would have tunneled through
	                       // something static or dynamic, or got far into it because something kinematic presses them
	float penetration;     // deepest overlap at the start of the last step, m
	int64_t steps;         // steps taken, those of dt 0 included
	uint64_t device_bytes; // device memory of the pools, bytes
	float joint_gap; // widest gap of a joint at the start of the last step, m: by how much a distance is off that a
	                 // rigid lock holds. Locks with a lock_hertz of their own, gears and pulleys do not count. More
	                 // than some mm in a world at rest means that joints shake or are overloaded
} scree_counters;

// bodies, dynamic_bodies, collidables and attributes are current; the other counters are those of the last step.
static inline scree_status scree_world_get_counters(scree_world* world, scree_counters* counters);

typedef struct scree_timings // milliseconds of the last step; zero unless scree_world_def.timings is set
{
	float step; // wall-clock time of scree_world_step, from the upload of changes until the device has finished
	float transform, broad_phase, narrow_phase, color, solve, finalize;
	float queries; // of the last call of queries, without transfers
} scree_timings;

// The times of the last step. Zero before the first step.
static inline scree_status scree_world_get_timings(scree_world* world, scree_timings* timings);

typedef struct scree_traffic // memory traffic of the solve stage in the last step
{
	int constraints;           // touching contacts that were solved
	int passes;                // passes over all constraints
	uint64_t constraint_bytes; // read and written for constraints, which are streamed in every pass
	uint64_t body_bytes;       // read and written for bodies, much of which caches can serve
} scree_traffic;

// The bytes that the solve stage of the last step read and wrote, counted from the algorithm: the same on every device,
// regardless of caches. The sum of both byte counts divided by scree_timings.solve is the achieved bandwidth. Zero
// before the first step.
static inline scree_status scree_world_get_traffic(scree_world* world, scree_traffic* traffic);

// Measures the copy bandwidth of the world's device, in bytes per second, reads plus writes; a CPU uses all threads.
// Takes some milliseconds on a GPU and up to a second elsewhere. Allocates 512 MB for that time, or less if there is
// less. The world does not change.
SCREE_API scree_status scree_world_measure_bandwidth(scree_world* world, double* bandwidth);

// Blocks until the device has finished all queued work.
SCREE_API scree_status scree_world_wait(scree_world* world);

// ---------------------------------------------------------------------------------------------------------------
// Attributes: shape and surface, shared by many collidables
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_attribute
{
	uint32_t index, generation;
} scree_attribute;

static const scree_attribute SCREE_NULL_ATTRIBUTE = {0, 0};
static inline bool scree_attribute_is_null(scree_attribute attribute)
{
	return attribute.index == 0 && attribute.generation == 0;
}
static inline bool scree_attribute_equals(scree_attribute a, scree_attribute b)
{
	return a.index == b.index && a.generation == b.generation;
}

typedef enum scree_shape_kind
{
	SCREE_SHAPE_CIRCLE,
	SCREE_SHAPE_CAPSULE,
	SCREE_SHAPE_SEGMENT,
	SCREE_SHAPE_POLYGON,
} scree_shape_kind;

// A shape in local coordinates: all points within radius of the convex hull of the vertices.
typedef struct scree_shape
{
	scree_shape_kind kind;
	int count;                              // 1 circle, 2 capsule and segment, 3 to 8 polygon
	float radius;                           // m; polygon: rounding radius; segment: 0
	scree_vec vertices[SCREE_MAX_VERTICES]; // polygon: convex, counter-clockwise
	scree_vec normals[SCREE_MAX_VERTICES];  // outward, of the edge from vertex i to i + 1; filled by scree_shape_make_*
	scree_vec centroid;                     // filled by scree_shape_make_*
	float area;                             // m^2; 0 for a segment; filled by scree_shape_make_*
	float inertia; // m^4: about the centroid, per unit of density; filled by scree_shape_make_*
	float reach;   // m: largest distance from the origin to a point of the shape; filled by scree_shape_make_*
} scree_shape;

// Make a shape; lengths in m. Each fails with SCREE_ERROR_INVALID if a value is not finite, a size is below 1 mm, or a
// coordinate exceeds SCREE_MAX_COORDINATE. Bodies of 4 cm and more suit the solver best; smaller ones, down to 2 mm, come to rest too, heaps of
// them with at least 4 substeps (docs/manifolds.md, "Small bodies").
SCREE_API scree_status scree_shape_make_box(float half_width, float half_height, scree_shape* shape);
SCREE_API scree_status scree_shape_make_circle(scree_vec center, float radius, scree_shape* shape);
SCREE_API scree_status scree_shape_make_capsule(scree_vec a, scree_vec b, float radius, scree_shape* shape);
SCREE_API scree_status scree_shape_make_segment(scree_vec a, scree_vec b, scree_shape* shape);

// A convex polygon of 3 to 8 corners in clockwise or counter-clockwise order, rounded by radius (m; 0: sharp). Fails
// with SCREE_ERROR_INVALID if a corner is concave, collinear or coincident; scree_shape_make_hull drops such corners. A corner is
// coincident if it is closer to another than a twentieth of the largest distance of two corners, at most 5 mm and at least 0.5 mm;
// it is collinear if it is closer than a tenth of that to the line between its neighbors.
SCREE_API scree_status scree_shape_make_polygon(const scree_vec* corners, int count, float radius, scree_shape* shape);

// The convex hull of 3 to 64 points. Coincident points are merged, collinear corners dropped, as above. Fails with
// SCREE_ERROR_INVALID if the hull has fewer than 3 or more than 8 corners. Method: Barber, Dobkin, Huhdanpaa, The
// Quickhull Algorithm for Convex Hulls, 1996.
SCREE_API scree_status scree_shape_make_hull(const scree_vec* points, int count, float radius, scree_shape* shape);

// Transforms a shape: rotates it by pose.rotation, then translates it by pose.position.
SCREE_API scree_status scree_shape_transform(const scree_shape* shape, scree_pose pose, scree_shape* transformed);

typedef struct scree_attribute_def
{
	uint32_t size; // set by scree_attribute_def_default
	scree_shape shape;
	float density;            // kg/m^2, 0 or 1e-6 to 1e9, default 1; of a body without any mass see scree_body_get_mass
	float friction;           // 0 to 1e6, default 0.6; a pair uses the geometric mean, at most 1000
	float restitution;        // 0 to 100, default 0; above 1 it adds speed; a pair uses the larger value
	float rolling_resistance; // 0 to 1e6, default 0; times the larger radius of the pair it is a lever arm in m
	float tangent_speed;      // speed of a conveyor belt along the surface, m/s, default 0; clockwise around the
	                          // shape if positive, so that a body on top moves to the right
	scree_vec one_way; // if it is not 0: a one-way platform, solid only for what comes from this side; a direction
	                   // in the frame of the shape, at least 1e-3 long. docs/rules.md; default 0
	int material;      // 0 to 255, default 0: what scree_world_set_material_pair names
} scree_attribute_def;

// Default values, with a box 1 m wide and high.
static inline scree_attribute_def scree_attribute_def_default(void);

// Creates an attribute, or returns the existing one with equal values. Attributes are immutable and live until they are
// destroyed, or their world is.
SCREE_API scree_status scree_attribute_create(scree_world* world, const scree_attribute_def* def,
                                              scree_attribute* attribute);

// Releases what one scree_attribute_create returned. An attribute that was created several times, by equal values, is
// destroyed by the last of as many calls, which is refused (SCREE_ERROR_INVALID) while a collidable uses the attribute.
// Later attributes reuse the slot; the handle stays stale.
SCREE_API scree_status scree_attribute_destroy(scree_world* world, scree_attribute attribute);
SCREE_API bool scree_attribute_is_valid(const scree_world* world, scree_attribute attribute);

// The values from which an attribute was created.
static inline scree_status scree_attribute_get_def(const scree_world* world, scree_attribute attribute,
                                                   scree_attribute_def* def);

typedef struct scree_material_pair // what a pair of materials does instead of what their attributes say
{
	uint32_t size;     // set by scree_material_pair_default
	float friction;    // 0 to 1e6, at most 1000 counts; NaN (default): as ever
	float restitution; // 0 to 100; NaN (default): as ever
	bool ignored;      // they pass through each other, as if their filters kept them apart; default false
	// m/s, within SCREE_MAX_COORDINATE: how fast the two surfaces run past each other, clockwise around each of the two shapes if
	// positive; NaN (default): the sum of both, as ever
	float tangent_speed;
} scree_material_pair;

static inline scree_material_pair scree_material_pair_default(void);

// Says what collidables of two materials (0 to 255, also twice the same) do with each other; the order of the two makes no difference.
// pair null: nothing but what their attributes say. Takes effect in the next step, also where they touch already: a contact that is
// ignored from now on ends with its event, and one that is not any more begins anew.
SCREE_API scree_status scree_world_set_material_pair(scree_world* world, int material_a, int material_b,
                                                     const scree_material_pair* pair);
static inline scree_status scree_world_get_material_pair(const scree_world* world, int material_a, int material_b,
                                                         scree_material_pair* pair);

// ---------------------------------------------------------------------------------------------------------------
// Bodies
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_body
{
	uint32_t index, generation;
} scree_body;

static const scree_body SCREE_NULL_BODY = {0, 0};
static inline bool scree_body_is_null(scree_body body) { return body.index == 0 && body.generation == 0; }
static inline bool scree_body_equals(scree_body a, scree_body b)
{
	return a.index == b.index && a.generation == b.generation;
}

typedef enum scree_body_type
{
	SCREE_BODY_STATIC,    // does not move; infinite mass
	SCREE_BODY_KINEMATIC, // moves with the velocity that the user sets; infinite mass
	SCREE_BODY_DYNAMIC,   // moves by forces and contacts
} scree_body_type;

enum // bits of scree_body_def.locks
{
	SCREE_LOCK_X = 1,
	SCREE_LOCK_Y = 2,
	SCREE_LOCK_ROTATION = 4,
};

// Two collidables may touch if the category of each is in the mask of the other. If both have the same non-zero group,
// only the group decides: positive always, negative never.
typedef struct scree_filter
{
	uint64_t category; // default 1
	uint64_t mask;     // default all
	int32_t group;     // default 0
} scree_filter;

enum // bits of scree_collidable_def.reports: which events list a collidable. One of the two needs the bit
{
	SCREE_REPORT_TOUCHES = 1,  // scree_events.touches_began, touches_ended
	SCREE_REPORT_HITS = 2,     // scree_events.hits
	SCREE_REPORT_APPROVAL = 4, // scree_events.approvals: what it begins to touch waits for scree_world_approve_contacts
};

// Bits of scree_body_def.sensor and scree_collidable_def.sensor: what a sensor sees. A sensor touches nothing, and nothing stops at
// it; it says what overlaps it (scree_events.visits_began, scree_collidable_get_visits). It may belong to a body of any type, or to
// none, sees nothing of its own body, and adds to the body's mass unless its density is 0. Filters apply, joints do not.
enum
{
	SCREE_SENSOR_MOVING = 1,  // collidables of dynamic and kinematic bodies
	SCREE_SENSOR_STATIC = 2,  // of static bodies, or without a body
	SCREE_SENSOR_SENSORS = 4, // other sensors
};

typedef struct scree_body_def
{
	uint32_t size;             // set by scree_body_def_default
	scree_body_type type;      // default SCREE_BODY_DYNAMIC
	scree_pose pose;           // of the body's origin; default: the world's origin, not rotated
	scree_velocity velocity;   // of the center of mass; default 0
	float gravity_scale;       // default 1
	float linear_damping;      // 1/s, >= 0, default 0
	float angular_damping;     // 1/s, >= 0, default 0
	uint32_t locks;            // bits of SCREE_LOCK_*; default 0
	scree_attribute attribute; // if not null: the body gets one collidable with it, at the body's origin
	scree_filter filter;       // of that collidable
	uint64_t user;             // user data of the body and of that collidable, not simulated; default 0
	bool disabled;             // starts disabled, see scree_body_set_enabled; default false
	uint32_t reports;          // of that collidable: bits of SCREE_REPORT_*; default 0
	uint32_t sensor;           // of that collidable: bits of SCREE_SENSOR_*; default 0
} scree_body_def;

static inline scree_body_def scree_body_def_default(void);
SCREE_API scree_filter scree_filter_default(void);

// Creates count bodies from count definitions and writes their handles to bodies (may be null). On failure no body is
// created.
SCREE_API scree_status scree_bodies_create(scree_world* world, const scree_body_def* defs, int count,
                                           scree_body* bodies);
SCREE_API scree_status scree_body_create(scree_world* world, const scree_body_def* def, scree_body* body);

// Destroys bodies with their collidables and contacts. On failure, for instance because a body is named twice, none is
// destroyed.
SCREE_API scree_status scree_bodies_destroy(scree_world* world, const scree_body* bodies, int count);
SCREE_API scree_status scree_body_destroy(scree_world* world, scree_body body);

SCREE_API bool scree_body_is_valid(const scree_world* world, scree_body body);

// Writes the handles of up to capacity bodies in ascending index order, and sets count to the number of bodies.
SCREE_API scree_status scree_world_get_bodies(const scree_world* world, scree_body* bodies, int capacity, int* count);

// Batches. Each takes count handles and count values. On failure nothing has changed. If a body is named twice, both
// values are applied, in order. Forces, torques and impulses act on dynamic bodies only.
SCREE_API scree_status scree_bodies_apply_forces(scree_world* world, const scree_body* bodies, const scree_vec* forces,
                                                 int count); // N, at the center of mass, during the next step
SCREE_API scree_status scree_bodies_apply_torques(scree_world* world, const scree_body* bodies, const float* torques,
                                                  int count); // N m, during the next step
SCREE_API scree_status scree_bodies_apply_impulses(scree_world* world, const scree_body* bodies,
                                                   const scree_vec* impulses,
                                                   int count); // N s, at the center of mass, immediately
SCREE_API scree_status scree_bodies_apply_angular_impulses(scree_world* world, const scree_body* bodies,
                                                           const float* impulses,
                                                           int count); // N m s, immediately
SCREE_API scree_status scree_bodies_apply_forces_at(scree_world* world, const scree_body* bodies,
                                                    const scree_vec* forces, const scree_vec* points,
                                                    int count); // N, at world points, m
SCREE_API scree_status scree_bodies_apply_impulses_at(scree_world* world, const scree_body* bodies,
                                                      const scree_vec* impulses, const scree_vec* points, int count);
SCREE_API scree_status scree_bodies_set_velocities(scree_world* world, const scree_body* bodies,
                                                   const scree_velocity* velocities, int count);
SCREE_API scree_status scree_bodies_set_linear_velocities(scree_world* world, const scree_body* bodies,
                                                          const scree_vec* velocities,
                                                          int count); // m/s; angular ones stay
SCREE_API scree_status scree_bodies_set_angular_velocities(scree_world* world, const scree_body* bodies,
                                                           const float* velocities,
                                                           int count); // rad/s; linear ones stay
SCREE_API scree_status scree_bodies_set_poses(scree_world* world, const scree_body* bodies, const scree_pose* poses,
                                              int count); // teleports; velocities do not change

// Sets the poses that kinematic bodies have at the end of the next step with dt > 0: poses of their origins, within
// SCREE_MAX_COORDINATE. Static and dynamic bodies are refused. During that step the body has the velocity that takes it there, by
// the shorter rotation (half a circle is counter-clockwise), so that it pushes and carries what it touches. At the end it
// is exactly there and stands still: its velocity is 0 before that step and after it.
//
// Locked motion stays locked. A body that would exceed max_speed, or turn by more than a step can
// (scree_world_def.max_speed), arrives all the same, but others feel only the limited velocity.
//
// A second target replaces the first. Setting the velocity, changing the type or destroying the body drops the target;
// scree_body_set_pose only moves the start. A step of dt 0, a refused step and steps while the body is disabled keep it.
SCREE_API scree_status scree_bodies_set_targets(scree_world* world, const scree_body* bodies, const scree_pose* poses,
                                                int count);

SCREE_API scree_status scree_bodies_get_poses(scree_world* world, const scree_body* bodies, scree_pose* poses,
                                              int count); // of the bodies' origins
// The world also stores what rounding a position to float leaves over, and the getters do not return it. Setting a pose
// that was read may therefore move a body by half the spacing of floats.
SCREE_API scree_status scree_bodies_get_velocities(scree_world* world, const scree_body* bodies,
                                                   scree_velocity* velocities, int count);

typedef struct scree_body_state
{
	scree_pose pose; // of the body's origin
	scree_velocity velocity;
} scree_body_state;

// Writes the states of up to capacity bodies in ascending index order, and their handles to bodies (may be null). Sets
// count to the number of bodies.
SCREE_API scree_status scree_world_get_states(scree_world* world, scree_body* bodies, scree_body_state* states,
                                              int capacity, int* count);

// The same for one body.
SCREE_API scree_status scree_body_apply_force(scree_world* world, scree_body body, scree_vec force);
SCREE_API scree_status scree_body_apply_force_at(scree_world* world, scree_body body, scree_vec force, scree_vec point);
SCREE_API scree_status scree_body_apply_torque(scree_world* world, scree_body body, float torque);
SCREE_API scree_status scree_body_apply_impulse(scree_world* world, scree_body body, scree_vec impulse);
SCREE_API scree_status scree_body_apply_impulse_at(scree_world* world, scree_body body, scree_vec impulse,
                                                   scree_vec point);
SCREE_API scree_status scree_body_apply_angular_impulse(scree_world* world, scree_body body, float impulse);
SCREE_API scree_status scree_body_set_velocity(scree_world* world, scree_body body, scree_velocity velocity);
SCREE_API scree_status scree_body_get_velocity(scree_world* world, scree_body body, scree_velocity* velocity);
SCREE_API scree_status scree_body_set_linear_velocity(scree_world* world, scree_body body, scree_vec velocity);
SCREE_API scree_status scree_body_set_angular_velocity(scree_world* world, scree_body body, float velocity);
SCREE_API scree_status scree_body_set_target(scree_world* world, scree_body body, scree_pose pose);
SCREE_API scree_status scree_body_set_pose(scree_world* world, scree_body body, scree_pose pose);
SCREE_API scree_status scree_body_get_pose(scree_world* world, scree_body body, scree_pose* pose);

// Converts a point (m) from the body's frame to the world and back; the velocity (m/s) of the body at a world point.
SCREE_API scree_status scree_body_get_world_point(scree_world* world, scree_body body, scree_vec local,
                                                  scree_vec* point);
SCREE_API scree_status scree_body_get_local_point(scree_world* world, scree_body body, scree_vec point,
                                                  scree_vec* local);
SCREE_API scree_status scree_body_get_point_velocity(scree_world* world, scree_body body, scree_vec point,
                                                     scree_vec* velocity);

// Settings of one body; units and ranges as in scree_body_def. Changes are uploaded with the next batch.
SCREE_API scree_status scree_body_set_type(scree_world* world, scree_body body,
                                           scree_body_type type); // recreates its contacts
SCREE_API scree_status scree_body_get_type(const scree_world* world, scree_body body, scree_body_type* type);
SCREE_API scree_status scree_body_set_damping(scree_world* world, scree_body body, float linear, float angular);
SCREE_API scree_status scree_body_get_damping(const scree_world* world, scree_body body, float* linear, float* angular);
SCREE_API scree_status scree_body_set_gravity_scale(scree_world* world, scree_body body, float scale);
SCREE_API scree_status scree_body_get_gravity_scale(const scree_world* world, scree_body body, float* scale);
SCREE_API scree_status scree_body_set_locks(scree_world* world, scree_body body, uint32_t locks);
SCREE_API scree_status scree_body_get_locks(const scree_world* world, scree_body body, uint32_t* locks);
SCREE_API scree_status scree_body_set_user(scree_world* world, scree_body body,
                                           uint64_t user); // not that of its collidables
SCREE_API scree_status scree_body_get_user(const scree_world* world, scree_body body, uint64_t* user);

// Whether bodies take part. One that is disabled is as good as not there: it does not move, nothing touches it, forces
// and gravity do not reach it, and its collidables are not shown (scree_render_row.attribute is -1). Its contacts end as
// they do when it is destroyed. All else stays and can be read and set as ever, with its velocity, its pose and its
// collidables; forces on it are lost. When it is enabled it goes on with that velocity, and its contacts are new. It counts
// in scree_counters.bodies. Enabling what is enabled changes nothing, nor does disabling what is disabled.
SCREE_API scree_status scree_bodies_set_enabled(scree_world* world, const scree_body* bodies, const bool* enabled,
                                                int count); // all or none
SCREE_API scree_status scree_body_set_enabled(scree_world* world, scree_body body, bool enabled);
SCREE_API bool scree_body_is_enabled(const scree_world* world, scree_body body); // false for one that is not there

// Pairs of bodies that never touch each other, whatever their filters; the order of the two makes no difference. A pair that touches
// now ends its touch in the next step, with its event; one that is admitted again begins anew. Joints that keep two bodies apart do so
// beside it. Destroying a body removes its pairs. A world holds up to 16,777,216.
SCREE_API scree_status scree_bodies_set_excluded(scree_world* world, const scree_body* a, const scree_body* b,
                                                 const bool* excluded, int count); // all or none
SCREE_API scree_status scree_body_set_excluded(scree_world* world, scree_body body, scree_body other, bool excluded);
SCREE_API bool scree_body_is_excluded(const scree_world* world, scree_body body, scree_body other);
// Writes up to capacity of the bodies that a body never touches, in ascending index order, and sets count to their number.
SCREE_API scree_status scree_body_get_excluded(scree_world* world, scree_body body, scree_body* others, int capacity,
                                               int* count);

typedef struct scree_mass
{
	float mass;       // kg, 0 for static and kinematic bodies
	float inertia;    // kg m^2 about the center of mass
	scree_vec center; // of mass, in the body's frame, m
} scree_mass;

// The mass is computed from the densities of the collidables; a dynamic body with zero mass, as all densities are 0 or it has no
// collidable, gets 1 kg and cannot rotate. scree_body_set_mass overrides it until a collidable is added or removed, or
// gets an attribute with another shape or density; it holds again after the body was of another type. When the center of mass changes,
// each point of the body keeps its velocity: that of the new center is v + w x (new - old). Its mass is
// 1e-15 to 1e30 kg; its inertia is 1e-20 to 1e30 kg m^2, or 0 for a body that cannot rotate. A step takes at least a thousandth of the
// mass times the square of the longest arm for the inertia, that to a joint or to the end of a solid shape: with less, floats have
// no digits left for the impulses of joints and contacts. It fails with SCREE_ERROR_INVALID for a body that is not dynamic.
SCREE_API scree_status scree_body_get_mass(const scree_world* world, scree_body body, scree_mass* mass);
SCREE_API scree_status scree_body_set_mass(scree_world* world, scree_body body, scree_mass mass);
SCREE_API scree_status scree_bodies_set_masses(scree_world* world, const scree_body* bodies, const scree_mass* masses,
                                               int count); // on failure nothing has changed

// ---------------------------------------------------------------------------------------------------------------
// Collidables
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_collidable
{
	uint32_t index, generation;
} scree_collidable;

static const scree_collidable SCREE_NULL_COLLIDABLE = {0, 0};
static inline bool scree_collidable_is_null(scree_collidable collidable)
{
	return collidable.index == 0 && collidable.generation == 0;
}
static inline bool scree_collidable_equals(scree_collidable a, scree_collidable b)
{
	return a.index == b.index && a.generation == b.generation;
}

typedef struct scree_collidable_def
{
	uint32_t size; // set by scree_collidable_def_default
	scree_attribute attribute;
	scree_body body; // null: the collidable belongs to no body, and only reports overlaps
	scree_pose pose; // in the body's frame, or in the world if there is no body
	scree_filter filter;
	uint64_t user;    // user data, not simulated; default 0
	uint32_t reports; // bits of SCREE_REPORT_*; default 0
	uint32_t sensor;  // bits of SCREE_SENSOR_*: what it sees; default 0: it is no sensor
} scree_collidable_def;

static inline scree_collidable_def scree_collidable_def_default(void);

// Creates count collidables and writes their handles to collidables (may be null). The masses of their bodies are
// computed again. On failure no collidable is created.
SCREE_API scree_status scree_collidables_create(scree_world* world, const scree_collidable_def* defs, int count,
                                                scree_collidable* collidables);
SCREE_API scree_status scree_collidable_create(scree_world* world, const scree_collidable_def* def,
                                               scree_collidable* collidable);

// Destroys collidables with their contacts; the masses of their bodies are computed again. On failure, for instance
// because a collidable is named twice, none is destroyed.
SCREE_API scree_status scree_collidables_destroy(scree_world* world, const scree_collidable* collidables, int count);
SCREE_API scree_status scree_collidable_destroy(scree_world* world, scree_collidable collidable);

SCREE_API bool scree_collidable_is_valid(const scree_world* world, scree_collidable collidable);

// Writes the handles of up to capacity collidables of a body, in the order in which they were added, and sets count to
// their number. A null body lists the collidables without a body, in ascending index order.
SCREE_API scree_status scree_body_get_collidables(const scree_world* world, scree_body body,
                                                  scree_collidable* collidables, int capacity, int* count);

// Settings of one collidable. Changes are uploaded with the next batch.
SCREE_API scree_status scree_collidable_get_body(const scree_world* world, scree_collidable collidable,
                                                 scree_body* body);
SCREE_API scree_status scree_collidable_get_attribute(const scree_world* world, scree_collidable collidable,
                                                      scree_attribute* attribute);
// Another attribute. Where the shapes are equal, contacts stay with their impulses, and the pair's surface is that of the
// new attribute from the next step on; else they start anew. The mass of a dynamic body follows from its collidables again,
// unless shape and density are equal. An attribute that it has already changes nothing.
SCREE_API scree_status scree_collidable_set_attribute(scree_world* world, scree_collidable collidable,
                                                      scree_attribute attribute);
SCREE_API scree_status scree_collidable_get_local_pose(const scree_world* world, scree_collidable collidable,
                                                       scree_pose* pose);
SCREE_API scree_status scree_collidable_get_filter(const scree_world* world, scree_collidable collidable,
                                                   scree_filter* filter);
SCREE_API scree_status scree_collidable_set_filter(scree_world* world, scree_collidable collidable,
                                                   scree_filter filter); // recreates its contacts
SCREE_API scree_status scree_collidable_get_user(const scree_world* world, scree_collidable collidable, uint64_t* user);
SCREE_API scree_status scree_collidable_set_user(scree_world* world, scree_collidable collidable, uint64_t user);
// From the next step on. A touch that began with the old bits still ends. scree_collidables_set_reports sets as many at once; on
// failure none has changed.
SCREE_API scree_status scree_collidable_get_reports(const scree_world* world, scree_collidable collidable,
                                                    uint32_t* reports);
SCREE_API scree_status scree_collidable_set_reports(scree_world* world, scree_collidable collidable, uint32_t reports);
SCREE_API scree_status scree_collidables_set_reports(scree_world* world, const scree_collidable* collidables,
                                                     const uint32_t* reports, int count);

// From the next step on. What becomes a sensor touches nothing any more: its touches end. What is none any more has no visits.
SCREE_API scree_status scree_collidable_get_sensor(const scree_world* world, scree_collidable collidable,
                                                   uint32_t* sensor);
SCREE_API scree_status scree_collidable_set_sensor(scree_world* world, scree_collidable collidable, uint32_t sensor);

// Teleports collidables without a body. Fails with SCREE_ERROR_INVALID if one belongs to a body.
SCREE_API scree_status scree_collidables_set_poses(scree_world* world, const scree_collidable* collidables,
                                                   const scree_pose* poses, int count);

// ---------------------------------------------------------------------------------------------------------------
// Paths
//
// A path is a smooth curve through points, on which joints of type SCREE_JOINT_PATH hold bodies: a wire with beads, a rail
// with wagons. Its points are in frame A of the joints that use it, so that one path can lie in the world, and another one in
// a body that moves. Positions on a path are arc lengths from its first point, in metres.
//
// The curve is the cubic spline through the points whose parameter is the sum of their distances, so its curvature is
// continuous. Give more points where it bends more: 12 on a full circle are within 1e-3 of its radius, 24 within 1e-4.
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_path
{
	uint32_t index, generation;
} scree_path;

static const scree_path SCREE_NULL_PATH = {0, 0};
static inline bool scree_path_is_null(scree_path path) { return path.index == 0 && path.generation == 0; }
static inline bool scree_path_equals(scree_path a, scree_path b)
{
	return a.index == b.index && a.generation == b.generation;
}

typedef struct scree_path_def
{
	uint32_t size;           // set by scree_path_def_default
	const scree_vec* points; // m; neighbors at least 1e-4 apart
	int count;               // 2 to 65,536; at least 3 for a closed path
	bool closed;             // goes on from the last point to the first; default false
	uint64_t user;           // user data, not simulated; default 0
} scree_path_def;

static inline scree_path_def scree_path_def_default(void);

// Creates a path and writes its handle to *path (may be null).
SCREE_API scree_status scree_path_create(scree_world* world, const scree_path_def* def, scree_path* path);

// Fails with SCREE_ERROR_INVALID while a joint uses the path.
SCREE_API scree_status scree_path_destroy(scree_world* world, scree_path path);
SCREE_API bool scree_path_is_valid(const scree_world* world, scree_path path);

// Writes the handles of up to capacity paths in ascending index order, and sets count to their number.
SCREE_API scree_status scree_world_get_paths(const scree_world* world, scree_path* paths, int capacity, int* count);

// m
SCREE_API scree_status scree_path_get_length(const scree_world* world, scree_path path, float* length);

// The point at an arc length, and the direction of the path there. A closed path goes on in the next lap; beyond an end of
// an open one it is the end.
SCREE_API scree_status scree_path_get_pose(const scree_world* world, scree_path path, float along, scree_pose* pose);

// The arc length at which the path is nearest to a point of frame A.
SCREE_API scree_status scree_path_get_nearest(const scree_world* world, scree_path path, scree_vec point, float* along);

// Writes up to capacity of the points from which a path was made, and sets count to their number.
SCREE_API scree_status scree_path_get_points(const scree_world* world, scree_path path, scree_vec* points, int capacity,
                                             int* count);
SCREE_API bool scree_path_is_closed(const scree_world* world, scree_path path); // false for one that is not there
SCREE_API scree_status scree_path_get_user(const scree_world* world, scree_path path, uint64_t* user);
SCREE_API scree_status scree_path_set_user(scree_world* world, scree_path path, uint64_t user);

// ---------------------------------------------------------------------------------------------------------------
// Joints
//
// A joint holds two frames together: frame A in body A, frame B in body B. It measures three coordinates of frame B in
// frame A: the translation along the x axis of frame A, the translation across it (along its y axis), and the angle. Each
// coordinate can be locked, and can have limits, a spring and a motor. A type of joint (scree_joint_def_make) is a choice
// of these, which can be changed.
//
// A joint of type DISTANCE measures along the line from anchor A to anchor B instead: its translation along is the distance.
// Joints of types GEAR and PULLEY couple what is measured of each body in the world: see scree_joint_side.
//
// A joint of type PATH holds anchor B on a path, which lies in frame A. Its translation along is the arc length of the path,
// over all laps of a closed one; across is the distance from the path, positive to the left of its direction; the angle is
// that of frame B to the direction of the path. At the ends of an open path it is stopped, as by limits.
//
// Either body can be null: its frame is then in the world. Joints with a static or kinematic body are usual; between two
// bodies that cannot move, or with a disabled body, a joint rests.
//
// Method: Erin Catto, Soft Constraints, GDC 2011; Solver2D, 2024. docs/joints.md has the formulas, and what each type of
// other engines corresponds to.
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_joint
{
	uint32_t index, generation;
} scree_joint;

static const scree_joint SCREE_NULL_JOINT = {0, 0};
static inline bool scree_joint_is_null(scree_joint joint) { return joint.index == 0 && joint.generation == 0; }
static inline bool scree_joint_equals(scree_joint a, scree_joint b)
{
	return a.index == b.index && a.generation == b.generation;
}

typedef enum scree_joint_type // which coordinates are locked, and what else scree_joint_def_make sets
{
	SCREE_JOINT_FREE,      // none: a start for joints of your own
	SCREE_JOINT_DISTANCE,  // along, at along.target (1 m); unlock it for a spring, or for a rope with limits
	SCREE_JOINT_REVOLUTE,  // along and across: a hinge
	SCREE_JOINT_PRISMATIC, // across and angle: a slider along the x axis of frame A
	SCREE_JOINT_SLOT,      // across: a pin in a slot along the x axis of frame A
	SCREE_JOINT_WELD,      // all; lock_hertz makes it soft
	SCREE_JOINT_WHEEL,     // across; spring along the x axis of frame A of 1 Hz and damping ratio 0.7
	SCREE_JOINT_MOTOR,     // none; motors of speed 0 and of no force on all three: friction, or a drive
	SCREE_JOINT_TARGET,    // none; springs of 5 Hz and damping ratio 1 along and across: pulls a body to frame A
	SCREE_JOINT_FILTER,    // none: the two bodies do not collide, and that is all
	SCREE_JOINT_GEAR,      // along, of a coupling (scree_joint_side) of two angles
	SCREE_JOINT_PULLEY,    // along, of a coupling of two distances; the two bodies may collide
	SCREE_JOINT_PATH,      // across: a bead on a wire; lock the angle as well for a wagon on a rail
} scree_joint_type;

// "free", "distance", ...; never null.
SCREE_API const char* scree_joint_type_name(scree_joint_type type);

typedef enum scree_coordinate // of frame B in frame A
{
	SCREE_ALONG,
	SCREE_ACROSS,
	SCREE_ANGLE,
} scree_coordinate;

// Soft locks and springs swing and decay as their frequency and damping ratio say, up to a twelfth of the substep rate. Stiffer ones,
// and many on one body, are damped more, so that none adds energy.
typedef struct scree_joint_coordinate // units: m and N, or rad and N m for the angle
{
	float target; // at which a lock holds it, to which a spring pulls it; default 0
	bool locked;
	bool limited; // to the range from lower to upper; the angle counts all turns
	bool spring;
	bool motor;
	float lock_hertz;           // stiffness of a soft lock, Hz, 0 to 1e6; 0 (default): as stiff as the joint
	float lock_damping_ratio;   // 0 to 1e6, default 0
	float lower, upper;         // lower <= upper; default 0
	float spring_hertz;         // 0 to 1e6, default 0: the spring is off, whatever its damping ratio
	float spring_damping_ratio; // 0 to 1e6, default 0
	float spring_max;           // largest force or torque of the spring, >= 0, default FLT_MAX
	float spring_push;          // the same of one that increases the coordinate; the smaller one holds
	float spring_pull;          // and of one that decreases it: with a push of 0 a spring of DISTANCE is a rubber band
	float motor_speed;          // m/s, rad/s; default 0
	float motor_max; // largest force or torque of the motor, >= 0, default 0: it is off; with speed 0 it is friction
} scree_joint_coordinate;

typedef enum scree_measure // of a frame in a base, which is a frame of the world
{
	SCREE_MEASURE_ANGLE,       // rad, over all turns
	SCREE_MEASURE_TRANSLATION, // m: of the anchor along the x axis of the base
	SCREE_MEASURE_DISTANCE,    // m: of the anchor from the position of the base
} scree_measure;

// One side of a coupling. The coordinate along of joints of types GEAR and PULLEY is the measure of frame B in its base, plus
// ratio times the measure of frame A in its base. It can be locked, limited, sprung and driven like any other; a force along
// it is a torque where it measures an angle of b. Bases do not move: couple a wheel with another of the same vehicle through
// both wheels' angles only if the vehicle does not turn.
typedef struct scree_joint_side
{
	scree_measure measure;
	scree_pose base;     // in the world; default: its origin
	float initial_angle; // rad: the angle that the first one is nearest to; default 0. scree_joint_def_couple sets it
} scree_joint_side;

typedef struct scree_joint_def
{
	uint32_t size; // set by scree_joint_def_make
	scree_joint_type type;
	scree_body body_a, body_b;   // null: the world; not the same body
	scree_pose frame_a, frame_b; // in the bodies' frames; default: the bodies' origins
	// By scree_coordinate. Limits, spring and motor of a locked one have no effect while it is locked. A definition whose motor
	// has a speed or a maximum where it is locked is refused; scree_joint_set_coordinate may lock what is driven for a while.
	scree_joint_coordinate coordinates[3];
	float hertz; // stiffness of locks and limits, Hz, 0 to 1e6, default 60; 0: rigid, and errors stay. No stiffness, of
	             // springs too, exceeds a quarter of the substep rate; joints in a row are stiffer (docs/joints.md)
	float damping_ratio;    // of them, 0 to 1e6, default 2
	bool collide_connected; // whether the two bodies may touch each other; default false
	bool can_break;         // ends when a threshold is exceeded; default false
	bool disabled;          // starts disabled, see scree_joint_set_enabled; default false
	// spring_max and motor_max of along and across are half axes of an ellipse, so that equal ones bound the force in any
	// direction; else each bounds its own coordinate. Default true for MOTOR and TARGET.
	bool elliptic;
	float force_threshold;     // N, >= 0, default FLT_MAX; a joint above it is reported: scree_world_get_joint_events
	float torque_threshold;    // N m, likewise
	uint64_t user;             // user data, not simulated; default 0
	float ratio;               // of types GEAR and PULLEY: of a's measure, -1e6 to 1e6, default 1
	scree_joint_side sides[2]; // of types GEAR and PULLEY: a, b; default: angles of a GEAR, distances of a PULLEY
	scree_path path;           // of type PATH
	// Of type PATH, m: where the search begins; its lap counts. Only another part of the path that is less than half as far
	// from anchor B is taken instead. Default 0.
	float initial_along;
} scree_joint_def;

// A definition with the defaults of a type, between the world and the world: set bodies and frames. An unknown type gives
// one that is refused.
static inline scree_joint_def scree_joint_def_make(scree_joint_type type);

// Sets frame_a and frame_b of a definition, whose bodies are set, so that both lie at a pose in the world, where the bodies
// are now. Locks and springs whose target is 0 then hold the bodies as they are. Of a PATH it sets frame_b alone: frame_a is the
// place of the path.
SCREE_API scree_status scree_joint_def_place(scree_world* world, scree_joint_def* def, scree_pose pose);

// Sets the target along of a GEAR or a PULLEY, whose bodies, frames, sides and ratio are set, to what it measures now: two
// wheels mesh as they are, a rope is as long as it is. Sets sides[].initial_angle to the angles measured.
SCREE_API scree_status scree_joint_def_couple(scree_world* world, scree_joint_def* def);

// Sets frame_b of a PATH, whose bodies, frame_a and path are set, so that it lies on the path at an arc length, along its
// direction, where the bodies are now. Sets initial_along to that arc length.
SCREE_API scree_status scree_joint_def_mount(scree_world* world, scree_joint_def* def, float along);

// Creates count joints from count definitions and writes their handles to joints (may be null). On failure no joint is
// created.
SCREE_API scree_status scree_joints_create(scree_world* world, const scree_joint_def* defs, int count,
                                           scree_joint* joints);
SCREE_API scree_status scree_joint_create(scree_world* world, const scree_joint_def* def, scree_joint* joint);

// Destroys joints. Destroying a body destroys its joints. On failure, for instance because a joint is named twice, none is
// destroyed.
SCREE_API scree_status scree_joints_destroy(scree_world* world, const scree_joint* joints, int count);
SCREE_API scree_status scree_joint_destroy(scree_world* world, scree_joint joint);

SCREE_API bool scree_joint_is_valid(const scree_world* world, scree_joint joint); // also one that broke

// Writes the handles of up to capacity joints in ascending index order, and sets count to their number: all joints, or those
// of one body.
SCREE_API scree_status scree_world_get_joints(const scree_world* world, scree_joint* joints, int capacity, int* count);
SCREE_API scree_status scree_body_get_joints(const scree_world* world, scree_body body, scree_joint* joints,
                                             int capacity, int* count);

// The values from which a joint was created, with all later changes. Bodies are null where they were.
static inline scree_status scree_joint_get_def(const scree_world* world, scree_joint joint, scree_joint_def* def);

// Changes. Each takes count joints and count values; on failure nothing has changed. Impulses stay, so that a motor can get
// another speed in every step. A joint that broke can be changed, and stays broken. An angle that gets a limit, a spring or a lock,
// and had none of them, counts from the turn that is nearest to these.
SCREE_API scree_status scree_joints_set_coordinates(scree_world* world, const scree_joint* joints,
                                                    scree_coordinate which, const scree_joint_coordinate* values,
                                                    int count);
SCREE_API scree_status scree_joints_set_targets(scree_world* world, const scree_joint* joints, scree_coordinate which,
                                                const float* targets, int count); // of locks and springs, m or rad
SCREE_API scree_status scree_joints_set_motor_speeds(scree_world* world, const scree_joint* joints,
                                                     scree_coordinate which, const float* speeds,
                                                     int count); // m/s or rad/s
SCREE_API scree_status scree_joints_set_frames(scree_world* world, const scree_joint* joints,
                                               const scree_pose* frames_a, const scree_pose* frames_b, int count);

// The same for one joint.
SCREE_API scree_status scree_joint_set_coordinate(scree_world* world, scree_joint joint, scree_coordinate which,
                                                  const scree_joint_coordinate* value);
SCREE_API scree_status scree_joint_get_coordinate(const scree_world* world, scree_joint joint, scree_coordinate which,
                                                  scree_joint_coordinate* value);
SCREE_API scree_status scree_joint_set_target(scree_world* world, scree_joint joint, scree_coordinate which,
                                              float target);
SCREE_API scree_status scree_joint_set_motor_speed(scree_world* world, scree_joint joint, scree_coordinate which,
                                                   float speed);
SCREE_API scree_status scree_joint_set_frames(scree_world* world, scree_joint joint, scree_pose frame_a,
                                              scree_pose frame_b);

// Whether joints act. One that is disabled does nothing, and does not keep its bodies from touching. It can be read and changed
// as ever, and begins anew when it is enabled, without impulses; it keeps its turns. One that broke stays broken. Enabling what
// is enabled changes nothing, nor does disabling what is disabled.
SCREE_API scree_status scree_joints_set_enabled(scree_world* world, const scree_joint* joints, const bool* enabled,
                                                int count); // all or none
SCREE_API scree_status scree_joint_set_enabled(scree_world* world, scree_joint joint, bool enabled);
SCREE_API bool scree_joint_is_enabled(const scree_world* world, scree_joint joint); // false for one that is not there

// Settings of one joint; units and ranges as in scree_joint_def.
SCREE_API scree_status scree_joint_set_stiffness(scree_world* world, scree_joint joint, float hertz,
                                                 float damping_ratio);
SCREE_API scree_status scree_joint_set_thresholds(scree_world* world, scree_joint joint, float force, float torque,
                                                  bool can_break);
// Of types GEAR and PULLEY only. Angles count on with the new ratio, so that a gear does not jump; distances do not.
SCREE_API scree_status scree_joint_set_ratio(scree_world* world, scree_joint joint, float ratio);
SCREE_API scree_status scree_joint_set_bases(scree_world* world, scree_joint joint, scree_pose base_a,
                                             scree_pose base_b); // in the world, as if they had always been there
SCREE_API scree_status scree_joint_set_elliptic(scree_world* world, scree_joint joint, bool elliptic);
SCREE_API scree_status scree_joint_set_collide_connected(scree_world* world, scree_joint joint, bool collides);
SCREE_API scree_status scree_joint_set_user(scree_world* world, scree_joint joint, uint64_t user);

typedef struct scree_joint_state
{
	// by scree_coordinate: m, m, rad; the angle counts all turns. Of a GEAR or a PULLEY: the coordinate along, the measure of a,
	// the measure of b
	float values[3];
	float speeds[3]; // their speeds: m/s, m/s, rad/s
	scree_vec force; // N: on body b, in the world, of the last substep; its opposite acts on body a
	float torque;    // N m: likewise
	bool broken;     // the joint broke, and does nothing
} scree_joint_state;

// The states of count joints at the current poses. Forces are 0 before the first step.
static inline scree_status scree_joints_get_states(scree_world* world, const scree_joint* joints,
                                                   scree_joint_state* states, int count);
static inline scree_status scree_joint_get_state(scree_world* world, scree_joint joint, scree_joint_state* state);

typedef struct scree_joint_event // a joint whose force or torque exceeded its threshold in the last step
{
	scree_joint joint;
	float force, torque; // N, N m: the largest of the substeps
	bool broken;         // it broke in this step
	uint64_t user;       // user data of the joint
} scree_joint_event;

// Writes up to capacity events of the last step, in ascending index order, and sets count to their number. Joints that were
// destroyed since are left out.
static inline scree_status scree_world_get_joint_events(scree_world* world, scree_joint_event* events, int capacity,
                                                        int* count);

// ---------------------------------------------------------------------------------------------------------------
// Contacts and overlaps
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_contact_point
{
	scree_vec point;       // m, in the world, halfway between the surfaces, at the start of the last step
	float separation;      // m, negative if overlapping, at the start of the last step; for a speculative contact the
	                       // remaining gap
	float normal_impulse;  // N s, of the last substep
	float tangent_impulse; // N s, of the last substep
	uint32_t feature;      // id of the two touching features; constant while they touch
} scree_contact_point;

typedef struct scree_contact_detail // what a point did in the last step that took time
{
	float total_impulse;  // N s, of the normal, summed over the substeps, restitution included
	float approach_speed; // m/s, at which the surfaces approached each other when the step began; 0 if they parted
	int touched;          // 1 if the surfaces touched in some substep, even if they have parted since
} scree_contact_detail;

typedef struct scree_contact
{
	scree_collidable a, b;
	scree_vec normal; // unit vector from a to b
	int color;        // of the solver's constraint graph coloring, 0 to 62: constraints of one color share no body that
	                  // can move. 63: contact of a hub (a body with more than 32 contacts, or
	                  // on belts that run against each other). -1: overlap
	int count;        // number of points, 1 or 2
	scree_contact_point points[2];
	scree_body body_a, body_b;       // of a and b; null for a collidable without a body
	uint64_t user_a, user_b;         // user data of a and b
	scree_contact_detail details[2]; // zeros unless scree_world_def.contact_details is set, or in an event
	int destroyed_a, destroyed_b;    // 1 in an event if the collidable was destroyed; a, b and bodies are old handles
} scree_contact;

// Writes up to capacity touching contacts between bodies and sets count to their number. The order is that of the
// contact pool, the same on all devices.
static inline scree_status scree_world_get_contacts(scree_world* world, scree_contact* contacts, int capacity,
                                                    int* count);

// The same for the contacts of one body, in the same order. The device gathers them, and only they are read.
static inline scree_status scree_body_get_contacts(scree_world* world, scree_body body, scree_contact* contacts,
                                                   int capacity, int* count);

// The same for pairs in which at least one collidable has no body. Impulses are zero. A pair is reported if the shapes
// are within the speculative distance, 0.02 m; they overlap if the separation is at most 0.
static inline scree_status scree_world_get_overlaps(scree_world* world, scree_contact* overlaps, int capacity,
                                                    int* count);

// ---------------------------------------------------------------------------------------------------------------
// Events
//
// What happened in the last step, for collidables that report it (scree_collidable_def.reports). Events change no motion,
// and their order is the same on all devices. A world in which nobody has reported pays nothing.
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_hit // two surfaces met fast
{
	scree_collidable a, b;
	scree_body body_a, body_b;    // null for a collidable without a body
	uint64_t user_a, user_b;      // user data of a and b
	scree_vec point;              // m, in the world: the point with the larger impulse
	scree_vec normal;             // unit vector from a to b
	float approach_speed;         // m/s: the larger one of the points, when the step began
	float impulse;                // N s: normal impulse of all points and substeps, restitution included
	int destroyed_a, destroyed_b; // as in scree_contact
} scree_hit;

typedef struct scree_visit // of a collidable to a sensor
{
	scree_collidable sensor, visitor;
	scree_body body_sensor, body_visitor;    // null for a collidable without a body
	uint64_t user_sensor, user_visitor;      // user data
	float time;                              // of the step at which the visit began, or ended: 0 to 1
	int destroyed_sensor, destroyed_visitor; // as in scree_contact
} scree_visit;

typedef struct scree_events
{
	uint32_t size, contact_size, hit_size; // set by scree_world_get_events

	// Touches of which one side has SCREE_REPORT_TOUCHES. A touch begins in the step in which the surfaces push each other or
	// overlap: contacts of surfaces that are only near do not count. It ends when they are farther apart than 0.02 m, and also
	// when a collidable is destroyed, disabled or gets another shape, filter or type of body, or when a joint keeps the two
	// apart. Each beginning has exactly one end. In one step, ends come before beginnings. Both are in an order that is the same on
	// all devices: beginnings in that of scree_world_get_contacts, with points, impulses and details; ends by index of a, then of b,
	// with handles, bodies and user data only.
	const scree_contact* touches_began;
	const scree_contact* touches_ended;

	// Contacts of which one side has SCREE_REPORT_HITS, and which exceeded scree_world_def.hit_speed and hit_impulse, in the order of
	// scree_world_get_contacts.
	const scree_hit* hits;

	int touches_began_count, touches_ended_count, hit_count;

	// Visits to sensors that began and ended in the step, by index of the sensor, then of the visitor. Each beginning has exactly
	// one end. What passes through a sensor within the step begins and ends.
	uint32_t visit_size; // set by scree_world_get_events
	int visits_began_count, visits_ended_count;
	const scree_visit* visits_began;
	const scree_visit* visits_ended;

	// Joints whose force or torque exceeded a threshold, by index: as scree_world_get_joint_events.
	uint32_t joint_size; // set by scree_world_get_events
	int joint_count;
	const scree_joint_event* joints;

	// Contacts of which one side has SCREE_REPORT_APPROVAL, and which touch, or will in this step, for the first time since the two
	// were apart: scree_world_approve_contacts. Their impulses are 0. In the order of scree_world_get_contacts.
	int approval_count;
	const scree_contact* approvals;
} scree_events;

// The events of the last step. The arrays belong to the world; they are valid until the next call of this function or of
// scree_world_step, and until the world is destroyed. What was destroyed since the step is named, and marked.
static inline scree_status scree_world_get_events(scree_world* world, scree_events* events);

// Answers for the contacts in scree_events.approvals of the last step; count is approval_count, or it is refused. true: the contact acts from
// the next step on until the two are farther apart than 0.02 m. false, or no answer before the next step: the two pass through each
// other until then. After that they are asked about again. A step of dt 0, or one that fails, is no answer: what has none yet is
// asked about again in the next step. In the step in which a contact is asked about, its bodies move no further than to where they
// meet, and keep their velocities. A second call before the next step replaces the answers of the first.
SCREE_API scree_status scree_world_approve_contacts(scree_world* world, const bool* approved, int count);

typedef struct scree_moved_body // a body at another pose than before
{
	scree_body body;
	uint64_t user; // user data
	scree_pose pose;
	scree_velocity velocity;
} scree_moved_body;

typedef struct scree_moved_bodies
{
	uint32_t size, body_size; // set by scree_world_get_moved_bodies
	int count;
	const scree_moved_body* bodies; // by index
} scree_moved_bodies;

// The bodies that moved since the last call, by motion or by the user, and those made since: what a renderer or a network has to
// know. A body moved if a number of its pose, as scree_body_get_pose returns it, differs from that at the last call, by however little:
// one at rest under a load may move by a rounding in each step. A body that came back to where it was did not move, nor did one that
// got another center of mass, type or velocity. The first call lists all bodies. The array belongs to the world; it is valid until the
// next call of this function, or until the world is destroyed. The device puts the list together, and only the list is read.
static inline scree_status scree_world_get_moved_bodies(scree_world* world, scree_moved_bodies* list);

// Writes up to capacity visits to a sensor that lasted at the end of the last step, by index of the visitor, and sets count to their
// number; .time is when each began, if that was in this step. Fails with SCREE_ERROR_INVALID for a collidable that is no sensor.
static inline scree_status scree_collidable_get_visits(scree_world* world, scree_collidable sensor, scree_visit* visits,
                                                       int capacity, int* count);

// Slower and weaker contacts are no hits: m/s and N s, at least 0. From the next step on.
SCREE_API scree_status scree_world_set_hit_thresholds(scree_world* world, float speed, float impulse);

// ---------------------------------------------------------------------------------------------------------------
// Queries
//
// Questions about the world as it is now, changes since the last step included: what a ray or a moving shape meets first, or
// all that it meets, what overlaps a place, what is nearest. They change no bit of the world. Answers and their order are the
// same on all devices. docs/queries.md has examples and times.
//
// One call takes one query or a million. On a GPU a call costs about 70 us even for one query, so ask for many at once.
// The first call after a step or a change computes boxes of all collidables that can move: 25 ns each on one CPU thread.
//
// Queries see shapes as they are, not the distance of 0.02 m at which contacts begin. Collidables of disabled bodies are not
// there. Coordinates are at most SCREE_MAX_COORDINATE, translations at most twice that.
// ---------------------------------------------------------------------------------------------------------------

enum // bits of scree_query_def.kinds: collidables that are seen
{
	SCREE_QUERY_STATIC = 1,    // of static bodies
	SCREE_QUERY_KINEMATIC = 2, // of kinematic bodies
	SCREE_QUERY_DYNAMIC = 4,   // of dynamic bodies
	SCREE_QUERY_FREE = 8,      // without a body
	SCREE_QUERY_SENSORS = 16,  // sensors, on whatever body; the other bits do not see them
};

typedef struct scree_query_def // what the queries of a call see
{
	uint32_t size;     // set by scree_query_def_default
	uint32_t kinds;    // bits of SCREE_QUERY_*; default: those of bodies
	uint64_t category; // a collidable is seen if its mask has a bit of this; default all
	uint64_t mask;     // and if this has a bit of its category; default all
	bool any;          // only scree_query_result.hit is wanted, which is faster: the rest is zero; default false
	bool skip_inside;  // what a ray or shape begins inside of is not seen; default false
	bool one_way;      // one-way platforms are seen from the side from which they are solid only; default false
} scree_query_def;

static inline scree_query_def scree_query_def_default(void);

typedef struct scree_ray // 32 bytes
{
	scree_vec origin;      // m
	scree_vec translation; // m: to the end of the ray. Zero asks what is at the origin
	float radius;          // m: of a circle that moves along the ray, 0 for a point
	uint32_t reserved;     // 0
	scree_body ignored;    // a body that is not seen, or null; one that was destroyed is as good as null
} scree_ray;

typedef struct scree_probe // 32 bytes: a place for the shape of a call
{
	scree_pose pose;       // where the shape is; the rotation of {0} is refused
	scree_vec translation; // m: to where it moves, without turning; 0 for one that rests
	scree_body ignored;    // as in scree_ray
} scree_probe;

typedef struct scree_query_result // 32 bytes: the answer of a query
{
	scree_collidable collidable; // null if nothing was found
	scree_vec point;             // m: of its surface, where it is met or nearest; if inside, where the query begins
	scree_vec normal;            // unit vector from the collidable to the query; 0 if inside
	float fraction;              // of the translation, 0 to 1; of the nearest the distance, m, below 0 if they overlap
	bool hit;                    // whether something was found
	bool inside;                 // it overlapped already where the query began
	uint16_t reserved;
} scree_query_result;

typedef struct scree_query_results // all that was found
{
	uint32_t size;                     // set by the function that fills it
	int count;                         // of results
	const scree_query_result* results; // by query, then by fraction, then by index of the collidable
	const int* first; // of query k: the first in results; those of all queries, and count behind the last
} scree_query_results;

// The first collidable that each ray meets; of those met at the same fraction, the one with the lower index. def may be null
// for the default. Method: an 8-ary tree of boxes, searched in the order of the distance; rounded polygons are exact.
SCREE_API scree_status scree_world_cast_rays(scree_world* world, const scree_query_def* def, const scree_ray* rays,
                                             int count, scree_query_result* found);
SCREE_API scree_status scree_world_cast_ray(scree_world* world, scree_vec origin, scree_vec translation,
                                            scree_query_result* found); // with the default definition

// The same for a shape, which moves from the pose of each probe; a null shape is a point. Shapes are as in
// scree_attribute_def. Exact, without iterations: a ray against the Minkowski sum of the two shapes.
SCREE_API scree_status scree_world_cast_shapes(scree_world* world, const scree_query_def* def, const scree_shape* shape,
                                               const scree_probe* probes, int count, scree_query_result* found);
SCREE_API scree_status scree_world_cast_shape(scree_world* world, const scree_shape* shape, scree_pose pose,
                                              scree_vec translation, scree_query_result* found);

// The nearest collidable within a distance of each shape, in m, with its nearest point; a null shape is a point. Of
// those that overlap, the one that overlaps most. Translations must be 0, and def->any false.
SCREE_API scree_status scree_world_find_nearest(scree_world* world, const scree_query_def* def,
                                                const scree_shape* shape, const scree_probe* probes, int count,
                                                float distance, scree_query_result* found);

// Queries in memory of the device, which stay there: scree_world_share_queries shares memory as scree_world_share_memory does, with the
// same conditions. The others answer count rays or probes that begin so many bytes into it, and write the answers from another offset,
// which may be the same; found lies there when they return. Both offsets are multiples of 4. Nobody checks these items: those that the
// calls above would refuse have any answer.
SCREE_API scree_status scree_world_share_queries(scree_world* world, int file_descriptor, size_t bytes);
SCREE_API scree_status scree_world_cast_shared_rays(scree_world* world, const scree_query_def* def, size_t rays_offset,
                                                    int count, size_t found_offset);
SCREE_API scree_status scree_world_cast_shared_shapes(scree_world* world, const scree_query_def* def,
                                                      const scree_shape* shape, size_t probes_offset, int count,
                                                      size_t found_offset);

// All collidables that the rays, or the shapes, meet; with a translation of 0 all that they overlap. The arrays of list belong
// to the world, and are valid until the next call that fills a list, or until the world is destroyed. def->any must be false.
static inline scree_status scree_world_list_rays(scree_world* world, const scree_query_def* def, const scree_ray* rays,
                                                 int count, scree_query_results* list);
static inline scree_status scree_world_list_shapes(scree_world* world, const scree_query_def* def,
                                                   const scree_shape* shape, const scree_probe* probes, int count,
                                                   scree_query_results* list);

// All collidables that overlap a box, at least 2 mm wide and high, a shape at a pose, or a point, with the default definition.
static inline scree_status scree_world_overlap_box(scree_world* world, scree_box box, scree_query_results* list);
static inline scree_status scree_world_overlap_shape(scree_world* world, const scree_shape* shape, scree_pose pose,
                                                     scree_query_results* list);
static inline scree_status scree_world_overlap_point(scree_world* world, scree_vec point, scree_query_results* list);

typedef struct scree_blast_def // an explosion, or with a negative impulse an implosion
{
	uint32_t size;      // set by scree_blast_def_default
	scree_vec position; // m
	float radius;       // m, 0 to SCREE_MAX_COORDINATE: nearer surfaces get the whole impulse; default 1
	float falloff;     // m, 0 to SCREE_MAX_COORDINATE: beyond the radius it falls to 0 within so many metres; default 1
	float impulse;     // N s per m of the width that a collidable turns to the blast; default 1
	uint64_t category; // as in scree_query_def; default all
	uint64_t mask;     // the same
} scree_blast_def;

static inline scree_blast_def scree_blast_def_default(void);

// Pushes the dynamic bodies around a position, and sets count (may be null) to the number of collidables that were pushed. Each gets
// an impulse at the point of it that is nearest to the position, away from it; one that the position is inside of at its centroid.
// Sensors, disabled bodies and what is beyond SCREE_MAX_COORDINATE are left alone. The impulses are applied as those of
// scree_bodies_apply_impulses_at, in the order of the collidables. Walls do not shield: ask scree_world_cast_rays, and push yourself. A list
// that a query returned stays valid.
SCREE_API scree_status scree_world_blast(scree_world* world, const scree_blast_def* def, int* count);

typedef struct scree_mover_def // characters of one kind: upright capsules that are moved by queries
{
	uint32_t size;  // set by scree_mover_def_default
	uint32_t kinds; // bits of SCREE_QUERY_*: what stops it; default those of bodies
	float
	    length; // m, 0 or 0.002 to SCREE_MAX_COORDINATE: between the centers of the capsule's ends, 0 for a circle; default 0.6
	float radius;      // m, 0.001 to SCREE_MAX_COORDINATE; default 0.3
	scree_vec up;      // unit vector; default (0, 1)
	float max_slope;   // rad, 0 to pi / 2: the steepest ground that it can stand on; default 50 degrees
	float step_height; // m, 0 to SCREE_MAX_COORDINATE: the highest step that it walks up; default 0.3
	float
	    snap_distance; // m, 0 to SCREE_MAX_COORDINATE: so far down it follows the ground that it stands on; default 0.3
	float skin;        // m, 0.001 to SCREE_MAX_COORDINATE: the distance that it keeps from everything; default 0.01
	uint64_t category; // as in scree_query_def; default all
	uint64_t mask;     // the same
} scree_mover_def;

static inline scree_mover_def scree_mover_def_default(void);

// A character. Begin with zeros, a position and a velocity. Then change velocity and ignored only.
typedef struct scree_mover
{
	scree_vec position;        // m: of the capsule's center
	scree_vec velocity;        // m/s, on top of that of the ground: what you wish; then what is left of it
	scree_body ignored;        // a body that it does not see, such as one that follows it; or null. As in scree_ray
	scree_collidable ground;   // what it stands on, null in the air
	scree_vec normal;          // of the ground, 0 in the air
	scree_pose ground_pose;    // of the body that it stands on, by which the next call moves it along
	scree_vec ground_velocity; // m/s: the velocity that the ground gave it. Add it to velocity when it jumps
	scree_collidable wall;     // the last wall, ceiling or steep slope that stopped it, or null
	scree_vec
	    wall_normal; // unit vector from the wall to it, or 0. Of a mover that is crushed: 0, and wall is what it overlaps
} scree_mover;

// Moves characters for a time dt (s, 0 to 1), after each step. They slide along walls, stand still on slopes, walk up steps, follow the
// ground down, ride on what moves below them, and are pushed out of what moves into them, and by kinematic bodies of any speed. One
// that nothing can push out, as between a lift and a ceiling, is crushed: it stays where it was, at rest, until it overlaps nothing.
// They do not collide with each other, and push no body: give wall an impulse yourself. Add gravity to the velocity of those in the
// air. A velocity against up is dropped on ground; one along up is a jump. def may be null for the default. Ten to twenty batches of queries, however many movers: the bits are the same
// on every device. Components of velocities are at most SCREE_MAX_COORDINATE. Fails without a change to movers.
SCREE_API scree_status scree_movers_move(scree_world* world, const scree_mover_def* def, scree_mover* movers, int count,
                                         float dt);

// ---------------------------------------------------------------------------------------------------------------
// Fields
//
// A field pushes the dynamic bodies in a region in each step: gravity of its own, attraction, a vortex, drag, wind, or a fluid in which
// they float. Its region is a shape that lies in the world or on a body, or everything. Fields add up. The force of a step is that at
// the poses in the middle of the step and the velocities at its start; docs/fields.md has the formulas. A world without fields pays
// nothing.
//
// Types UNIFORM, RADIAL, VORTEX and DRAG act on bodies, at the center of mass, while that is in the region. WIND acts on each
// collidable whose middle is in the region, BUOYANCY on the part of each collidable that is in it. Sensors, disabled bodies and the
// field's own body are left alone; nothing pushes back on the body of a field. Bodies of other types do not move by forces.
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_field
{
	uint32_t index, generation;
} scree_field;

static const scree_field SCREE_NULL_FIELD = {0, 0};
static inline bool scree_field_is_null(scree_field field) { return field.index == 0 && field.generation == 0; }
static inline bool scree_field_equals(scree_field a, scree_field b)
{
	return a.index == b.index && a.generation == b.generation;
}

typedef enum scree_field_type
{
	SCREE_FIELD_UNIFORM,  // acceleration and force, the same everywhere
	SCREE_FIELD_RADIAL,   // acceleration towards the origin of the field's frame; away from it if strength is negative
	SCREE_FIELD_VORTEX,   // acceleration around the origin, counter-clockwise; clockwise if strength is negative
	SCREE_FIELD_DRAG,     // of a medium, on bodies: linear and quadratic, and on their rotation
	SCREE_FIELD_WIND,     // of a medium, on the edges that face it: drag and lift by the square of the speed
	SCREE_FIELD_BUOYANCY, // of a fluid in the region; without a shape the fluid is below the x axis of the field's frame
} scree_field_type;

typedef enum scree_field_falloff // of RADIAL and VORTEX: strength times
{
	SCREE_FALLOFF_CONSTANT,       // 1
	SCREE_FALLOFF_LINEAR,         // 1 - r / radius, 0 from there on
	SCREE_FALLOFF_INVERSE,        // radius / r
	SCREE_FALLOFF_INVERSE_SQUARE, // (radius / r)^2
} scree_field_falloff;

// Members that its type does not use must be finite and in range, and have no effect.
typedef struct scree_field_def
{
	uint32_t size; // set by scree_field_def_default
	scree_field_type type;
	scree_body body;   // on which the region lies, and with which it is destroyed; null (default) for the world
	scree_pose pose;   // of the field's frame in the frame of the body, or in the world; default the origin
	scree_shape shape; // the region, in that frame; count 0 (default): everywhere. BUOYANCY: a polygon, not rounded
	bool disabled;     // does nothing; default false
	// Acts on collidables of the bits of mask whose masks have a bit of category; bodies: on those that have such a
	// collidable. Default all bits: then it acts on all, whatever their filters.
	uint64_t category, mask;
	scree_vec acceleration;      // UNIFORM, m/s^2, in the field's frame; default 0
	scree_vec force;             // UNIFORM, N, the same; default 0
	float strength;              // RADIAL, VORTEX, m/s^2; default 10
	scree_field_falloff falloff; // the same; default inverse square
	float radius;                // the same: of the falloff, m, 1e-3 to SCREE_MAX_COORDINATE; default 1
	float softening;             // the same, m, >= 0: r^2 is the squared distance plus the square of this; default 0.1
	scree_vec velocity;          // DRAG, WIND, BUOYANCY: of the medium, m/s, in the field's frame, on top of the body's
	float density;               // WIND, BUOYANCY: of the medium, kg/m^2, >= 0; default 1
	float drag;                  // the same, a coefficient: force = drag density / 2 width speed^2, >= 0; default 1
	float lift;                  // WIND: the same across the wind, >= 0; default 0
	float linear_drag;           // DRAG: force by the speed, kg/s; default 0. BUOYANCY: of 1 m^2; default 2. >= 0
	float quadratic_drag;        // DRAG: force by the square of the speed, kg/m, >= 0; default 0
	float spin_drag;             // DRAG: torque by the spin, N m s, >= 0; default 0
	float spin_drag_quadratic;   // DRAG: torque by the square of the spin, N m s^2, >= 0; default 0
	uint64_t user;               // user data, not simulated; default 0
} scree_field_def;

static inline scree_field_def scree_field_def_default(scree_field_type type);

// Creates a field and writes its handle to *field (may be null). Strengths, drags and densities are limited to 1e12.
SCREE_API scree_status scree_field_create(scree_world* world, const scree_field_def* def, scree_field* field);
SCREE_API scree_status scree_field_destroy(scree_world* world, scree_field field);
SCREE_API bool scree_field_is_valid(const scree_world* world, scree_field field);

// Reads and replaces all of a field but its size; its handle stays. It acts from the next step on.
static inline scree_status scree_field_get_def(const scree_world* world, scree_field field, scree_field_def* def);
SCREE_API scree_status scree_field_set_def(scree_world* world, scree_field field, const scree_field_def* def);

// The pose of the field's frame, as in scree_field_def.
SCREE_API scree_status scree_field_set_pose(scree_world* world, scree_field field, scree_pose pose);
SCREE_API scree_status scree_field_set_enabled(scree_world* world, scree_field field, bool enabled);

// Writes the handles of up to capacity fields in ascending index order, and sets count to their number.
SCREE_API scree_status scree_world_get_fields(const scree_world* world, scree_field* fields, int capacity, int* count);

// ---------------------------------------------------------------------------------------------------------------
// Two shapes, without a world
//
// The geometry of queries for shapes at poses of your own. Coordinates are at most SCREE_MAX_COORDINATE. Results are the same on every machine.
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_distance
{
	scree_vec point_a,
	    point_b;      // m: the nearest points of the surfaces, in the world; where they overlap, along the normal
	scree_vec normal; // unit vector from a to b
	float distance;   // m: of the surfaces; negative: minus the depth by which they overlap
} scree_distance;

// The distance of two shapes; a null shape is a point. Exact: the distance of a point from the Minkowski sum of the two.
SCREE_API scree_status scree_shapes_get_distance(const scree_shape* a, scree_pose pose_a, const scree_shape* b,
                                                 scree_pose pose_b, scree_distance* distance);

// Where a shape meets a ray, or where a meets b, which moves by a translation (m) without turning. found->collidable is null.
SCREE_API scree_status scree_shape_cast_ray(const scree_shape* shape, scree_pose pose, scree_vec origin,
                                            scree_vec translation, scree_query_result* found);
SCREE_API scree_status scree_shapes_cast(const scree_shape* a, scree_pose pose_a, const scree_shape* b,
                                         scree_pose pose_b, scree_vec translation, scree_query_result* found);

// Whether a point is in a shape, its surface included.
SCREE_API scree_status scree_shape_contains(const scree_shape* shape, scree_pose pose, scree_vec point, bool* contains);

// The time of impact of two shapes that move from one pose to another, at constant speed, turning the shorter way about
// their origins: the fraction of the motion at which their distance is at most 0.25 mm; found->hit is false if they do not
// meet. Method: conservative advancement (Brian Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996), at
// most 200 rounds; a motion that needs more counts as a hit where it ended.
SCREE_API scree_status scree_shapes_get_impact(const scree_shape* a, scree_pose from_a, scree_pose to_a,
                                               const scree_shape* b, scree_pose from_b, scree_pose to_b,
                                               scree_query_result* found);

// ---------------------------------------------------------------------------------------------------------------
// Drawing
//
// One row per collidable, laid out for a vertex buffer: row k is the collidable whose handle has the index k + 1.
// scree_world_get_render_rows copies the rows to the host. If scree_world_get_sharing returns more than
// SCREE_SHARING_COPIED, the rows can stay on the device: share a buffer that OpenGL draws from, and
// scree_world_write_render_rows writes into it. Both give the same bits. docs/share.md has an example.
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_render_row // 32 bytes
{
	scree_pose pose;   // of the attribute's shape in the world
	scree_vec center;  // vector from pose.position to the body's center of mass, world axes, m
	int32_t attribute; // index of the attribute's handle; -1: no collidable, skip the row
	int32_t body;      // index of the body's handle, 1 or more; -1: no body
} scree_render_row;

// Writes up to capacity rows of the current state and sets count to the number of rows: the highest collidable index so
// far plus one. rows may be null if capacity is 0.
SCREE_API scree_status scree_world_get_render_rows(scree_world* world, scree_render_row* rows, int capacity,
                                                   int* count);

// How this world can share render rows: as its device, but SCREE_SHARING_OPENGL only if the driver accepted
// scree_world_def.opengl.
SCREE_API scree_sharing scree_world_get_sharing(const scree_world* world);

// Shares memory that another API allocated on the same device (scree_device.uuid) and exported as an opaque file
// descriptor. Vulkan can export (VK_KHR_external_memory_fd), and OpenGL can import (GL_EXT_memory_object_fd). On
// success the world owns the descriptor. bytes is the usable size, at least one row. Fails with
// SCREE_ERROR_NOT_SUPPORTED if scree_world_get_sharing is not SCREE_SHARING_MEMORY, or if the driver rejects the
// memory. Sharing ends with the next call of this function, scree_world_unshare, a move to another device (which "auto"
// may do), or scree_world_destroy.
SCREE_API scree_status scree_world_share_memory(scree_world* world, int file_descriptor, size_t bytes);

// Shares a buffer object of the context scree_world_def.opengl, which must be current on the calling thread here and in
// scree_world_write_render_rows. bytes is the size of its storage, at least one row. The buffer and its storage must
// outlive the sharing. Fails with SCREE_ERROR_NOT_SUPPORTED if scree_world_get_sharing is not SCREE_SHARING_OPENGL, or
// if the driver rejects the buffer.
SCREE_API scree_status scree_world_share_opengl(scree_world* world, uint32_t buffer, size_t bytes);

// Ends all sharing, also of queries, and releases the imported memory or buffer. world may be null, and may share nothing.
SCREE_API void scree_world_unshare(scree_world* world);

// Writes the rows of the current state into the shared memory and sets count to their number. The rows are complete
// when this returns. The caller must ensure that OpenGL has finished reading the previous rows, for instance with a
// fence. Fails with SCREE_ERROR_INVALID, and still sets count, if the rows do not fit; share a larger buffer then.
SCREE_API scree_status scree_world_write_render_rows(scree_world* world, int* count);

// ---------------------------------------------------------------------------------------------------------------
// Versions
//
// The static inline functions above call these library functions and pass the size of the struct in the program. A
// binding for another language calls them directly. Members that the library does not know are set to 0.
// ---------------------------------------------------------------------------------------------------------------

SCREE_API void scree_world_def_default_sized(scree_world_def* def, size_t size);
static inline scree_world_def scree_world_def_default(void)
{
	scree_world_def def;
	scree_world_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API void scree_attribute_def_default_sized(scree_attribute_def* def, size_t size);
static inline scree_attribute_def scree_attribute_def_default(void)
{
	scree_attribute_def def;
	scree_attribute_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API void scree_body_def_default_sized(scree_body_def* def, size_t size);
static inline scree_body_def scree_body_def_default(void)
{
	scree_body_def def;
	scree_body_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API void scree_collidable_def_default_sized(scree_collidable_def* def, size_t size);
static inline scree_collidable_def scree_collidable_def_default(void)
{
	scree_collidable_def def;
	scree_collidable_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API scree_status scree_devices_get_sized(scree_device* devices, size_t size, int capacity, int* count);
static inline scree_status scree_devices_get(scree_device* devices, int capacity, int* count)
{
	return scree_devices_get_sized(devices, sizeof *devices, capacity, count);
}

SCREE_API scree_status scree_world_get_counters_sized(scree_world* world, scree_counters* counters, size_t size);
static inline scree_status scree_world_get_counters(scree_world* world, scree_counters* counters)
{
	return scree_world_get_counters_sized(world, counters, sizeof *counters);
}

SCREE_API scree_status scree_world_get_tuning_sized(const scree_world* world, scree_tuning* tuning, size_t size);
static inline scree_status scree_world_get_tuning(const scree_world* world, scree_tuning* tuning)
{
	return scree_world_get_tuning_sized(world, tuning, sizeof *tuning);
}

SCREE_API scree_status scree_world_get_timings_sized(scree_world* world, scree_timings* timings, size_t size);
static inline scree_status scree_world_get_timings(scree_world* world, scree_timings* timings)
{
	return scree_world_get_timings_sized(world, timings, sizeof *timings);
}

SCREE_API scree_status scree_world_get_traffic_sized(scree_world* world, scree_traffic* traffic, size_t size);
static inline scree_status scree_world_get_traffic(scree_world* world, scree_traffic* traffic)
{
	return scree_world_get_traffic_sized(world, traffic, sizeof *traffic);
}

SCREE_API scree_status scree_world_get_contacts_sized(scree_world* world, scree_contact* contacts, size_t size,
                                                      int capacity, int* count);
static inline scree_status scree_world_get_contacts(scree_world* world, scree_contact* contacts, int capacity,
                                                    int* count)
{
	return scree_world_get_contacts_sized(world, contacts, sizeof *contacts, capacity, count);
}

SCREE_API scree_status scree_body_get_contacts_sized(scree_world* world, scree_body body, scree_contact* contacts,
                                                     size_t size, int capacity, int* count);
static inline scree_status scree_body_get_contacts(scree_world* world, scree_body body, scree_contact* contacts,
                                                   int capacity, int* count)
{
	return scree_body_get_contacts_sized(world, body, contacts, sizeof *contacts, capacity, count);
}

SCREE_API scree_status scree_world_get_overlaps_sized(scree_world* world, scree_contact* overlaps, size_t size,
                                                      int capacity, int* count);
static inline scree_status scree_world_get_overlaps(scree_world* world, scree_contact* overlaps, int capacity,
                                                    int* count)
{
	return scree_world_get_overlaps_sized(world, overlaps, sizeof *overlaps, capacity, count);
}

SCREE_API scree_status scree_attribute_get_def_sized(const scree_world* world, scree_attribute attribute,
                                                     scree_attribute_def* def, size_t size);
static inline scree_status scree_attribute_get_def(const scree_world* world, scree_attribute attribute,
                                                   scree_attribute_def* def)
{
	return scree_attribute_get_def_sized(world, attribute, def, sizeof *def);
}

SCREE_API void scree_joint_def_make_sized(scree_joint_type type, scree_joint_def* def, size_t size);
static inline scree_joint_def scree_joint_def_make(scree_joint_type type)
{
	scree_joint_def def;
	scree_joint_def_make_sized(type, &def, sizeof def);
	return def;
}

SCREE_API void scree_path_def_default_sized(scree_path_def* def, size_t size);
static inline scree_path_def scree_path_def_default(void)
{
	scree_path_def def;
	scree_path_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API scree_status scree_joint_get_def_sized(const scree_world* world, scree_joint joint, scree_joint_def* def,
                                                 size_t size);
static inline scree_status scree_joint_get_def(const scree_world* world, scree_joint joint, scree_joint_def* def)
{
	return scree_joint_get_def_sized(world, joint, def, sizeof *def);
}

SCREE_API scree_status scree_joints_get_states_sized(scree_world* world, const scree_joint* joints,
                                                     scree_joint_state* states, size_t size, int count);
static inline scree_status scree_joints_get_states(scree_world* world, const scree_joint* joints,
                                                   scree_joint_state* states, int count)
{
	return scree_joints_get_states_sized(world, joints, states, sizeof *states, count);
}
static inline scree_status scree_joint_get_state(scree_world* world, scree_joint joint, scree_joint_state* state)
{
	return scree_joints_get_states_sized(world, &joint, state, sizeof *state, 1);
}

SCREE_API scree_status scree_world_get_joint_events_sized(scree_world* world, scree_joint_event* events, size_t size,
                                                          int capacity, int* count);
static inline scree_status scree_world_get_joint_events(scree_world* world, scree_joint_event* events, int capacity,
                                                        int* count)
{
	return scree_world_get_joint_events_sized(world, events, sizeof *events, capacity, count);
}

SCREE_API scree_status scree_world_get_events_sized(scree_world* world, scree_events* events); // with the sizes set
static inline scree_status scree_world_get_events(scree_world* world, scree_events* events)
{
	if (events)
	{
		events->size = (uint32_t)sizeof(scree_events);
		events->contact_size = (uint32_t)sizeof(scree_contact);
		events->hit_size = (uint32_t)sizeof(scree_hit);
		events->visit_size = (uint32_t)sizeof(scree_visit);
		events->joint_size = (uint32_t)sizeof(scree_joint_event);
	}
	return scree_world_get_events_sized(world, events);
}

SCREE_API scree_status scree_collidable_get_visits_sized(scree_world* world, scree_collidable sensor,
                                                         scree_visit* visits, size_t size, int capacity, int* count);
static inline scree_status scree_collidable_get_visits(scree_world* world, scree_collidable sensor, scree_visit* visits,
                                                       int capacity, int* count)
{
	return scree_collidable_get_visits_sized(world, sensor, visits, sizeof *visits, capacity, count);
}

SCREE_API scree_status scree_world_get_moved_bodies_sized(scree_world* world,
                                                          scree_moved_bodies* list); // with the sizes set
static inline scree_status scree_world_get_moved_bodies(scree_world* world, scree_moved_bodies* list)
{
	if (list)
	{
		list->size = (uint32_t)sizeof(scree_moved_bodies);
		list->body_size = (uint32_t)sizeof(scree_moved_body);
	}
	return scree_world_get_moved_bodies_sized(world, list);
}

SCREE_API void scree_material_pair_default_sized(scree_material_pair* pair, size_t size);
static inline scree_material_pair scree_material_pair_default(void)
{
	scree_material_pair pair;
	scree_material_pair_default_sized(&pair, sizeof pair);
	return pair;
}

SCREE_API scree_status scree_world_get_material_pair_sized(const scree_world* world, int material_a, int material_b,
                                                           scree_material_pair* pair, size_t size);
static inline scree_status scree_world_get_material_pair(const scree_world* world, int material_a, int material_b,
                                                         scree_material_pair* pair)
{
	return scree_world_get_material_pair_sized(world, material_a, material_b, pair, sizeof *pair);
}

SCREE_API void scree_blast_def_default_sized(scree_blast_def* def, size_t size);
static inline scree_blast_def scree_blast_def_default(void)
{
	scree_blast_def def;
	scree_blast_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API void scree_mover_def_default_sized(scree_mover_def* def, size_t size);
static inline scree_mover_def scree_mover_def_default(void)
{
	scree_mover_def def;
	scree_mover_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API void scree_field_def_default_sized(scree_field_def* def, size_t size, scree_field_type type);
static inline scree_field_def scree_field_def_default(scree_field_type type)
{
	scree_field_def def;
	scree_field_def_default_sized(&def, sizeof def, type);
	return def;
}

SCREE_API scree_status scree_field_get_def_sized(const scree_world* world, scree_field field, scree_field_def* def,
                                                 size_t size);
static inline scree_status scree_field_get_def(const scree_world* world, scree_field field, scree_field_def* def)
{
	return scree_field_get_def_sized(world, field, def, sizeof *def);
}

SCREE_API void scree_query_def_default_sized(scree_query_def* def, size_t size);
static inline scree_query_def scree_query_def_default(void)
{
	scree_query_def def;
	scree_query_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API scree_status scree_world_list_rays_sized(scree_world* world, const scree_query_def* def,
                                                   const scree_ray* rays, int count, scree_query_results* list,
                                                   size_t size);
static inline scree_status scree_world_list_rays(scree_world* world, const scree_query_def* def, const scree_ray* rays,
                                                 int count, scree_query_results* list)
{
	return scree_world_list_rays_sized(world, def, rays, count, list, sizeof *list);
}

SCREE_API scree_status scree_world_list_shapes_sized(scree_world* world, const scree_query_def* def,
                                                     const scree_shape* shape, const scree_probe* probes, int count,
                                                     scree_query_results* list, size_t size);
static inline scree_status scree_world_list_shapes(scree_world* world, const scree_query_def* def,
                                                   const scree_shape* shape, const scree_probe* probes, int count,
                                                   scree_query_results* list)
{
	return scree_world_list_shapes_sized(world, def, shape, probes, count, list, sizeof *list);
}
static inline scree_status scree_world_overlap_shape(scree_world* world, const scree_shape* shape, scree_pose pose,
                                                     scree_query_results* list)
{
	scree_probe probe = {pose, {0.0f, 0.0f}, {0, 0}};
	return scree_world_list_shapes_sized(world, NULL, shape, &probe, 1, list, sizeof *list);
}
static inline scree_status scree_world_overlap_point(scree_world* world, scree_vec point, scree_query_results* list)
{
	scree_pose pose = {{point.x, point.y}, {1.0f, 0.0f}};
	return scree_world_overlap_shape(world, NULL, pose, list);
}
SCREE_API scree_status scree_world_overlap_box_sized(scree_world* world, scree_box box, scree_query_results* list,
                                                     size_t size);
static inline scree_status scree_world_overlap_box(scree_world* world, scree_box box, scree_query_results* list)
{
	return scree_world_overlap_box_sized(world, box, list, sizeof *list);
}

#ifdef __cplusplus
}
#endif
#endif
