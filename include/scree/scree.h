// SPDX-License-Identifier: MIT
// scree.h -- the whole public interface of Scree, a 2D rigid body physics engine whose CPU and GPU leave the same bits.
//
// This header is also the manual. The shortest program is examples/hello.c.
//
// Units are metres, kilograms, seconds and radians. Angles turn counter-clockwise. A world is used by one thread at a
// time; different worlds may be used by different threads at once.
//
// Errors. Every function that can fail returns a scree_status. On anything but SCREE_OK nothing has changed, and
// scree_error() holds one sentence naming the argument and its value.
//
// Handles are an index and a generation. A handle that is all zero is null; a handle of something that has been
// destroyed is recognised and refused.
//
// Between two steps, changes (forces, velocities, poses, ...) are collected and travel to the device as one batch.
// Reading anything back sends what is pending first, so that one reads what one wrote.
//
// Versions. Definitions and results get further members with time, always at the end. So a definition begins with its
// size, which its default sets, and whoever fills a result is told its size; the functions that do so are at the end of
// this header. A program and a library of different versions work together, or the library refuses what it does not
// know with a sentence.
//
// Determinism. After the same calls in the same order, a world has the same scree_world_get_hash on every device, with
// any number of threads or lanes, and with every compiler that keeps IEEE 754 arithmetic.
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
#define SCREE_VERSION_MINOR 1
#define SCREE_VERSION_PATCH 0

// Most vertices of a convex polygon. The narrow phase clips in registers: a larger polygon costs every pair.
#define SCREE_MAX_VERTICES 8

// Coordinates beyond this many metres from the origin are refused: a float has steps of 8 mm there.
#define SCREE_HUGE 100000.0f

// ---------------------------------------------------------------------------------------------------------------
// Errors, hooks and version
// ---------------------------------------------------------------------------------------------------------------

typedef enum scree_status
{
	SCREE_OK = 0,
	SCREE_ERROR_INVALID = 1,       // an argument is out of its range; nothing changed
	SCREE_ERROR_STALE = 2,         // a handle is null or names something that was destroyed; nothing changed
	SCREE_ERROR_OUT_OF_MEMORY = 3, // host or device memory; nothing changed, unless in mid-step (scree_world_step)
	SCREE_ERROR_NO_DEVICE = 4,     // the device asked for is not there, or cannot keep the promise of equal bits
	SCREE_ERROR_DEVICE_FAILED = 5, // the driver reported an error in mid-run; the world can only be destroyed
	SCREE_ERROR_NOT_SUPPORTED = 6, // the device has no way to do this; nothing changed
	SCREE_ERROR_CROWDED = 7, // scree_world_step: more contacts than scree_world_def.contact_limit; nothing changed
} scree_status;

// The sentence of the last failure on this thread, or an empty string. Valid until the next failing call.
SCREE_API const char* scree_error(void);

// The name of a status, "ok", "invalid", ...; never null.
SCREE_API const char* scree_status_name(scree_status status);

// "0.1.0"
SCREE_API const char* scree_version(void);

typedef enum scree_log_level
{
	SCREE_LOG_INFO,
	SCREE_LOG_WARNING,
} scree_log_level;

// Hooks of the process. Null members mean the default. Set them before the first world is created and not while one
// exists. The pointed-to functions may be called from any thread that calls into Scree, and by a thread of its own that
// opens a GPU for a world of device "auto".
typedef struct scree_hooks
{
	void* (*allocate)(size_t bytes, size_t alignment, void* context); // alignment is a power of two; may return null
	void (*release)(void* memory, void* context);
	void (*log)(scree_log_level level, const char* sentence, void* context); // default: warnings to stderr
	void (*assert_failed)(const char* expression, const char* file, int line, void* context); // default: print, abort
	void* context;
} scree_hooks;

// Installs hooks, copied; null restores the defaults. Fails with SCREE_ERROR_INVALID while a world exists, or when only
// one of allocate and release is given.
SCREE_API scree_status scree_hooks_set(const scree_hooks* hooks);

// Bytes of host memory in use by the library now.
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

// The rotation by an angle in radians, from Scree's own polynomials: the same bits on every machine.
SCREE_API scree_rot scree_rot_make(float radians);

// The angle of a rotation, in [-pi, pi], from Scree's own polynomial.
SCREE_API float scree_rot_get_angle(scree_rot rotation);

// ---------------------------------------------------------------------------------------------------------------
// Devices
// ---------------------------------------------------------------------------------------------------------------

typedef enum scree_sharing // how the rows of scree_world_write_render_rows can reach an OpenGL buffer, best last
{
	SCREE_SHARING_COPIED, // through the host: scree_world_get_render_rows, then into the buffer
	SCREE_SHARING_MEMORY, // cl_khr_external_memory with file descriptors: scree_world_share_memory
	SCREE_SHARING_OPENGL, // cl_khr_gl_sharing: scree_world_share_opengl
} scree_sharing;

// "copied", "shared through external memory", "shared with OpenGL"
SCREE_API const char* scree_sharing_name(scree_sharing sharing);

typedef struct scree_device
{
	char name[128];        // what scree_world_def.device takes: "cpu", "opencl:NVIDIA H200"
	char driver[128];      // platform and driver version; for the CPU its widest lanes
	bool equal_bits;       // whether the promise of equal bits holds on it
	char reason[192];      // if not, why and what to do; otherwise empty
	int units;             // threads or compute units
	uint64_t memory;       // bytes
	scree_sharing sharing; // the best way that its driver offers
	uint8_t uuid[16];      // the one that OpenGL and Vulkan know it by; zeros where the driver does not say
} scree_device;

// Lists the devices of this machine, the CPU first. Writes at most capacity entries (devices may be null when capacity
// is 0) and the number there are into count. When there is no OpenCL, scree_opencl_remedy says what to install.
static inline scree_status scree_devices_get(scree_device* devices, int capacity, int* count);

// One sentence on what to install to get an OpenCL device, or an empty string when there is one.
SCREE_API const char* scree_opencl_remedy(void);

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

typedef struct scree_opengl // a context of OpenGL
{
	scree_window_system system;
	void *context, *display;
} scree_opengl;

typedef struct scree_world_def
{
	uint32_t size;           // set by scree_world_def_default
	scree_vec gravity;       // m/s^2, default (0, -10)
	const char* device;      // "auto" (default), "cpu", "opencl", "opencl:NAME" (NAME is any part of a device's name)
	int threads;             // CPU worker threads, 0 (default) for one a core, at most 64
	int lanes;               // CPU SIMD lanes: 0 (default) for the widest this processor has, or 1, 4, 8, 16
	bool allow_unequal_bits; // run on a device that cannot keep the promise of equal bits; default false
	bool timings;            // measure milliseconds a stage (scree_world_get_timings), which costs a GPU a little
	float contact_hertz;     // stiffness of contacts, 1/s, default 52; capped to 0.22 of the substep rate
	float contact_damping_ratio; // default 15
	float contact_push_speed;    // fastest speed at which overlap is pushed out, m/s, default 3
	float restitution_threshold; // slower impacts do not bounce, m/s, default 1
	float max_speed; // m/s, default 400: no body is faster when a step ends. Nor does one turn by more than half
	                 // a circle a step, or an eighth a substep
	const scree_opengl* opengl; // null (default), or the context that scree_world_share_opengl works in: copied; the
	                            // context itself is lent until the world's end, for it may move to its device
	int body_capacity;          // room to begin with; everything grows. 0 (default) for a small world
	int contact_capacity;       // the same for contacts
	int contact_limit; // most contacts, 300 bytes each; a step that finds more fails with SCREE_ERROR_CROWDED and changes
	                   // nothing. 0 (default) for 32 a collidable, and 2 million at least
} scree_world_def;

static inline scree_world_def scree_world_def_default(void);

// Creates a world into *world, which the caller owns and gives to scree_world_destroy. On failure *world is null.
//
// With device "auto" the world begins on the CPU. scree_world_step moves it to a GPU, and back, when its steps take
// less time there, and tells the log so (SCREE_LOG_INFO, with both times). A GPU is opened when the world is large
// enough to gain from it, by a thread while the world goes on; one that fails, or whose bits are not the CPU's, is
// logged and left alone. Moving changes no bit of the world. docs/auto.md says when it moves.
SCREE_API scree_status scree_world_create(const scree_world_def* def, scree_world** world);

// Destroys a world and everything in it. Null is allowed.
SCREE_API void scree_world_destroy(scree_world* world);

// Advances a world by dt seconds (1e-9 to 1, or 0) in substeps (1 to 64) solver substeps; 1/60 and 4 are usual. Based on
// Erin Catto, Solver2D, 2024; Macklin et al., Small Steps in Physics Simulation, 2019.
//
// A step of dt 0 only looks: contacts and overlaps begin and end by where everything is now, so that they can be read as
// soon as a world was built or a body was placed, with scree_counters.penetration. Poses, velocities, forces and targets
// stay, and so do the impulses of points that are still there; a contact that is new has none. It counts in
// scree_counters.steps, and scree_traffic is zero after it. It leaves the same bits on every device. The steps after it do
// not have the bits that they would have without it: boxes and contacts were made at another time.
//
// Bodies that lie in one place make contacts by the square of their number. Where these are more than
// scree_world_def.contact_limit, the step fails with SCREE_ERROR_CROWDED, and the sentence names the most crowded place
// and how many collidables are there; where there is no memory for them, it fails with SCREE_ERROR_OUT_OF_MEMORY.
// Nothing has changed then: time stands still, and when bodies have been moved apart or destroyed the world goes on.
//
// A step that breaks off later, because the device failed or had no memory left for what the solver needs, cannot be
// undone: from then on the world refuses every call that works on it with the same status, and can only be destroyed.
SCREE_API scree_status scree_world_step(scree_world* world, float dt, int substeps);

// Gravity, m/s^2, each component finite.
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

// How the solver is tuned now, and from the next step on. Get it, change members, set it: ranges are those of
// scree_world_def.
static inline scree_status scree_world_get_tuning(const scree_world* world, scree_tuning* tuning);
SCREE_API scree_status scree_world_set_tuning(scree_world* world, const scree_tuning* tuning);

// The device that the world runs on now, as in scree_device.name; owned by the world, and changed when it moves.
SCREE_API const char* scree_world_get_device(const scree_world* world);

// Moves a world to another device between two steps. device is what scree_world_def.device takes: "cpu", "opencl" or
// "opencl:NAME" for good, "auto" to leave the choice to scree_world_step from now on. The world goes on with the same
// bits: its hash, handles, contacts and impulses, and what the user has changed since the last step all stay. Threads,
// lanes, allow_unequal_bits and timings are those of its definition.
//
// It costs the opening of the device, some 0.3 s for a GPU, and the transfer of the world, some 1 kB a body; both
// devices hold it for that moment. On failure (SCREE_ERROR_NO_DEVICE, SCREE_ERROR_OUT_OF_MEMORY, ...) the world is
// where it was, as it was; only if the device that it was on failed while it was read (SCREE_ERROR_DEVICE_FAILED) it is
// broken, as after scree_world_step.
SCREE_API scree_status scree_world_move(scree_world* world, const char* device);

// CPU threads and lanes in use; 0 on an OpenCL device.
SCREE_API int scree_world_get_threads(const scree_world* world);
SCREE_API int scree_world_get_lanes(const scree_world* world);

// A 64-bit hash of all simulated state: equal worlds have equal hashes on every device.
SCREE_API scree_status scree_world_get_hash(scree_world* world, uint64_t* hash);

typedef struct scree_counters
{
	int bodies, dynamic_bodies;  // alive
	int collidables, attributes; // alive
	int contacts;                // pairs whose boxes overlap
	int touching;                // of these, the ones with points: within the speculative distance, or about to meet
	int colors;                  // colors in use
	int spokes;                  // contacts of hubs, bodies with more than 32 contacts: solved together, hub by hub
	int moved;                   // collidables whose enlarged box changed in the last step
	int new_contacts;            // pairs found in the last step
	int grown;                   // times that a buffer grew since the world was created
	int nonfinite;         // bodies frozen in the last step because their state was not finite: an infinite force, say;
	                       // what is finite never is. A body that leaves 1e8 m stops there
	int held;              // bodies that in the last step stopped in the surface of something static that they were
	                       // about to go through
	float penetration;     // deepest overlap of two cores at the start of the last step, m
	int64_t steps;         // steps taken, those of dt 0 as well
	uint64_t device_bytes; // memory of the pools on the device
} scree_counters;

static inline scree_status scree_world_get_counters(scree_world* world, scree_counters* counters);

typedef struct scree_timings // milliseconds of the last step; zero unless scree_world_def.timings
{
	float step; // wall clock of scree_world_step, from the upload of what was changed to the end of the device's work
	float transform, broad_phase, narrow_phase, color, solve, finalize;
} scree_timings;

static inline scree_status scree_world_get_timings(scree_world* world, scree_timings* timings);

typedef struct scree_traffic // memory that the solve stage of the last step asked for
{
	int constraints;           // touching contacts that it solved
	int passes;                // over all of them
	uint64_t constraint_bytes; // read and written of the constraints themselves, which stream by in every pass
	uint64_t body_bytes;       // read and written of bodies, which are few enough for a cache to serve much of it
} scree_traffic;

// Counts the bytes that the last step's solve stage read and wrote by its algorithm: the same on every device, whatever
// caches save. Both members over scree_timings.solve are the rate that it achieved. Zeros before the first step.
static inline scree_status scree_world_get_traffic(scree_world* world, scree_traffic* traffic);

// Measures how fast the world's device copies its own memory: bytes read and written a second, both counted, with all
// threads of a CPU. Takes some milliseconds on a GPU and up to a second elsewhere, and 512 MB for that time, or less
// where there is less. The world stays as it is.
SCREE_API scree_status scree_world_measure_bandwidth(scree_world* world, double* bandwidth);

// Waits until the device has finished everything that was asked of it.
SCREE_API scree_status scree_world_wait(scree_world* world);

// ---------------------------------------------------------------------------------------------------------------
// Attributes: what many collidables share
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

// A shape in local coordinates: the points within radius of the convex hull of the vertices.
typedef struct scree_shape
{
	scree_shape_kind kind;
	int count;                              // 1 circle, 2 capsule and segment, 3 to 8 polygon
	float radius;                           // m; of a polygon: its rounding; of a segment: 0
	scree_vec vertices[SCREE_MAX_VERTICES]; // polygon: convex, counter-clockwise
	scree_vec normals[SCREE_MAX_VERTICES];  // outward, of the edge from vertex i to i + 1; filled by scree_shape_make_*
	scree_vec centroid;                     // filled by scree_shape_make_*
	float area;                             // m^2; 0 for a segment; filled by scree_shape_make_*
	float inertia; // m^4: about the centroid, per unit of density; filled by scree_shape_make_*
	float reach;   // m: largest distance of a point of the shape from the origin; filled
} scree_shape;

// Each fails with SCREE_ERROR_INVALID on values that are not finite, sizes that are not positive (or under 1 mm), and
// coordinates beyond SCREE_HUGE.
SCREE_API scree_status scree_shape_make_box(float half_width, float half_height, scree_shape* shape);
SCREE_API scree_status scree_shape_make_circle(scree_vec center, float radius, scree_shape* shape);
SCREE_API scree_status scree_shape_make_capsule(scree_vec a, scree_vec b, float radius, scree_shape* shape);
SCREE_API scree_status scree_shape_make_segment(scree_vec a, scree_vec b, scree_shape* shape);

// A convex polygon, rounded by radius (0 for sharp corners), from 3 to 8 corners in order, either way round. Corners
// that are concave, coincident (closer than 5 mm) or collinear are refused: scree_shape_make_hull drops them instead.
SCREE_API scree_status scree_shape_make_polygon(const scree_vec* corners, int count, float radius, scree_shape* shape);

// The convex hull of any 3 to 64 points, welded at 5 mm and freed of collinear corners; refused when it has fewer than
// 3 or more than 8 corners. Method: Barber, Dobkin, Huhdanpaa, The Quickhull Algorithm for Convex Hulls, 1996.
SCREE_API scree_status scree_shape_make_hull(const scree_vec* points, int count, float radius, scree_shape* shape);

// Moves a shape: turned by pose.rotation, then shifted by pose.position.
SCREE_API scree_status scree_shape_transform(const scree_shape* shape, scree_pose pose, scree_shape* moved);

typedef struct scree_attribute_def
{
	uint32_t size; // set by scree_attribute_def_default
	scree_shape shape;
	float density;            // kg/m^2, >= 0, default 1
	float friction;           // >= 0, default 0.6; a pair takes the geometric mean, 1000 at most
	float restitution;        // 0 to 1, default 0; a pair takes the larger
	float rolling_resistance; // >= 0, default 0: times the larger radius of the pair, a lever in metres
	float tangent_speed; // m/s, default 0: a conveyor belt along the surface, clockwise around the shape: what lies
	                     // on top is carried to the right
} scree_attribute_def;

// Defaults with a box of half a metre a side (1 m wide).
static inline scree_attribute_def scree_attribute_def_default(void);

// Makes an attribute, or returns the one that exists with equal values. An attribute never changes, and lives until it is
// destroyed, or its world is.
SCREE_API scree_status scree_attribute_create(scree_world* world, const scree_attribute_def* def,
                                              scree_attribute* attribute);

// Gives back what one scree_attribute_create gave: an attribute that was made several times, by equal values, goes with
// the last of as many calls. That one is refused (SCREE_ERROR_INVALID) while a collidable has the attribute. Its place is
// taken by later ones, and the handle is stale for good.
SCREE_API scree_status scree_attribute_destroy(scree_world* world, scree_attribute attribute);
SCREE_API bool scree_attribute_is_valid(const scree_world* world, scree_attribute attribute);

// The values that an attribute was made of.
static inline scree_status scree_attribute_get_def(const scree_world* world, scree_attribute attribute,
                                                   scree_attribute_def* def);

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
	SCREE_BODY_STATIC,    // never moves by itself, infinite mass
	SCREE_BODY_KINEMATIC, // moves with the velocity that it is given, infinite mass
	SCREE_BODY_DYNAMIC,   // moved by forces and contacts
} scree_body_type;

enum // bits of scree_body_def.locks
{
	SCREE_LOCK_X = 1,
	SCREE_LOCK_Y = 2,
	SCREE_LOCK_ROTATION = 4,
};

// Two collidables may touch when each one's category is in the other's mask. An equal, non-zero group decides before
// that: positive always, negative never.
typedef struct scree_filter
{
	uint64_t category; // default 1
	uint64_t mask;     // default all
	int32_t group;     // default 0
} scree_filter;

typedef struct scree_body_def
{
	uint32_t size;             // set by scree_body_def_default
	scree_body_type type;      // default SCREE_BODY_DYNAMIC
	scree_pose pose;           // of the body's origin; default the world's origin
	scree_velocity velocity;   // default 0
	float gravity_scale;       // default 1
	float linear_damping;      // 1/s, >= 0, default 0
	float angular_damping;     // 1/s, >= 0, default 0
	uint32_t locks;            // default 0
	scree_attribute attribute; // when not null, the body is made with one collidable of it, at the body's origin
	scree_filter filter;       // of that collidable
	uint64_t user;             // kept for the user, not simulated; default 0
	bool disabled;             // begins as scree_body_set_enabled leaves it; default false
} scree_body_def;

static inline scree_body_def scree_body_def_default(void);
SCREE_API scree_filter scree_filter_default(void);

// Creates count bodies from count definitions. All or none: on failure no body is created. bodies (may be null) gets
// the handles.
SCREE_API scree_status scree_bodies_create(scree_world* world, const scree_body_def* defs, int count,
                                           scree_body* bodies);
SCREE_API scree_status scree_body_create(scree_world* world, const scree_body_def* def, scree_body* body);

// Destroys bodies and their collidables. Contacts end without a further word. All or none.
SCREE_API scree_status scree_bodies_destroy(scree_world* world, const scree_body* bodies, int count);
SCREE_API scree_status scree_body_destroy(scree_world* world, scree_body body);

SCREE_API bool scree_body_is_valid(const scree_world* world, scree_body body);

// Writes up to capacity handles of all bodies alive, by rising index, and how many there are.
SCREE_API scree_status scree_world_get_bodies(const scree_world* world, scree_body* bodies, int capacity, int* count);

// Batches. Each takes count handles and count values; all or none. A body named twice gets both, in order.
SCREE_API scree_status scree_bodies_apply_forces(scree_world* world, const scree_body* bodies, const scree_vec* forces,
                                                 int count); // N at the center of mass, for the next step
SCREE_API scree_status scree_bodies_apply_torques(scree_world* world, const scree_body* bodies, const float* torques,
                                                  int count); // N m, for the next step
SCREE_API scree_status scree_bodies_apply_impulses(scree_world* world, const scree_body* bodies,
                                                   const scree_vec* impulses,
                                                   int count); // N s at the center of mass, at once
SCREE_API scree_status scree_bodies_apply_angular_impulses(scree_world* world, const scree_body* bodies,
                                                           const float* impulses,
                                                           int count); // N m s, at once
SCREE_API scree_status scree_bodies_apply_forces_at(scree_world* world, const scree_body* bodies,
                                                    const scree_vec* forces, const scree_vec* points,
                                                    int count); // at world points, m
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
                                              int count); // teleport; velocities stay

// Where kinematic bodies are to be at the end of the next step that takes time: the poses of their origins, within
// SCREE_HUGE. A body that is static or dynamic is refused. In that step the body has the velocity that takes it there, the
// shorter way round (half a circle is counter-clockwise), so that what it touches is pushed and carried. At its end it is
// there, to the last bit, and stands still until it is told again: its velocity is 0 before that step and after it.
//
// What is locked stays. A body that is farther away than max_speed reaches, or turns by more than a step can
// (scree_world_def.max_speed), is there all the same, but others feel no more than the greatest speed and spin.
//
// A second target takes the place of the first. A target goes when the body's velocity is set, its type changes or it is
// destroyed; scree_body_set_pose only moves where it starts. Neither a step of dt 0, nor one that is refused, nor the steps
// in which the body is disabled use it up.
SCREE_API scree_status scree_bodies_set_targets(scree_world* world, const scree_body* bodies, const scree_pose* poses,
                                                int count);

SCREE_API scree_status scree_bodies_get_poses(scree_world* world, const scree_body* bodies, scree_pose* poses,
                                              int count); // of the bodies' origins; the world keeps more digits
// than a float has: set again, a body may be off by half the last
SCREE_API scree_status scree_bodies_get_velocities(scree_world* world, const scree_body* bodies,
                                                   scree_velocity* velocities, int count);

typedef struct scree_body_state
{
	scree_pose pose; // of the body's origin
	scree_velocity velocity;
} scree_body_state;

// The state of all bodies alive, by rising index: writes up to capacity of them, and how many there are. bodies (may be
// null) gets their handles.
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

// Points of a body: from its frame to the world and back, m, and how fast one that is now at a world point moves, m/s.
SCREE_API scree_status scree_body_get_world_point(scree_world* world, scree_body body, scree_vec local,
                                                  scree_vec* point);
SCREE_API scree_status scree_body_get_local_point(scree_world* world, scree_body body, scree_vec point,
                                                  scree_vec* local);
SCREE_API scree_status scree_body_get_point_velocity(scree_world* world, scree_body body, scree_vec point,
                                                     scree_vec* velocity);

// Settings of one body; ranges as in scree_body_def. Setters reach the device with the next batch.
SCREE_API scree_status scree_body_set_type(scree_world* world, scree_body body,
                                           scree_body_type type); // its contacts start anew
SCREE_API scree_status scree_body_get_type(const scree_world* world, scree_body body, scree_body_type* type);
SCREE_API scree_status scree_body_set_damping(scree_world* world, scree_body body, float linear, float angular);
SCREE_API scree_status scree_body_get_damping(const scree_world* world, scree_body body, float* linear, float* angular);
SCREE_API scree_status scree_body_set_gravity_scale(scree_world* world, scree_body body, float scale);
SCREE_API scree_status scree_body_get_gravity_scale(const scree_world* world, scree_body body, float* scale);
SCREE_API scree_status scree_body_set_locks(scree_world* world, scree_body body, uint32_t locks);
SCREE_API scree_status scree_body_get_locks(const scree_world* world, scree_body body, uint32_t* locks);
SCREE_API scree_status scree_body_set_user(scree_world* world, scree_body body, uint64_t user);
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

typedef struct scree_mass
{
	float mass;       // kg, 0 for static and kinematic bodies
	float inertia;    // kg m^2 about the center of mass
	scree_vec center; // of mass, in the body's frame, m
} scree_mass;

// Mass follows from the collidables' densities; a dynamic body without any mass counts as 1 kg that cannot turn.
// scree_body_set_mass overrides it (mass > 0, inertia >= 0) until a collidable is added or removed, or gets an attribute of
// another shape or density.
SCREE_API scree_status scree_body_get_mass(const scree_world* world, scree_body body, scree_mass* mass);
SCREE_API scree_status scree_body_set_mass(scree_world* world, scree_body body, scree_mass mass);
SCREE_API scree_status scree_bodies_set_masses(scree_world* world, const scree_body* bodies, const scree_mass* masses,
                                               int count); // all or none

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
	scree_body body; // null for a collidable without a body: it detects overlaps and nothing answers to it
	scree_pose pose; // in the body's frame; in the world when there is no body
	scree_filter filter;
	uint64_t user;
} scree_collidable_def;

static inline scree_collidable_def scree_collidable_def_default(void);

SCREE_API scree_status scree_collidables_create(scree_world* world, const scree_collidable_def* defs, int count,
                                                scree_collidable* collidables);
SCREE_API scree_status scree_collidable_create(scree_world* world, const scree_collidable_def* def,
                                               scree_collidable* collidable);
SCREE_API scree_status scree_collidables_destroy(scree_world* world, const scree_collidable* collidables, int count);
SCREE_API scree_status scree_collidable_destroy(scree_world* world, scree_collidable collidable);
SCREE_API bool scree_collidable_is_valid(const scree_world* world, scree_collidable collidable);

// Writes up to capacity handles of a body's collidables, in the order that they were added, and how many there are. A
// null body lists the collidables without a body, by rising index.
SCREE_API scree_status scree_body_get_collidables(const scree_world* world, scree_body body,
                                                  scree_collidable* collidables, int capacity, int* count);

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
                                                   scree_filter filter); // its contacts start anew
SCREE_API scree_status scree_collidable_get_user(const scree_world* world, scree_collidable collidable, uint64_t* user);
SCREE_API scree_status scree_collidable_set_user(scree_world* world, scree_collidable collidable, uint64_t user);

// Teleports collidables that have no body; the others belong to their bodies and are refused.
SCREE_API scree_status scree_collidables_set_poses(scree_world* world, const scree_collidable* collidables,
                                                   const scree_pose* poses, int count);

// ---------------------------------------------------------------------------------------------------------------
// Contacts and overlaps
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_contact_point
{
	scree_vec point;       // m, world, halfway between the surfaces, where the last step found it
	float separation;      // m, negative when overlapping, at the start of the last step; where fast bodies were about
	                       // to meet in it, as much as they had left to go
	float normal_impulse;  // N s, of the last substep
	float tangent_impulse; // N s
	uint32_t feature;      // names the two features that touch; stable while they do
} scree_contact_point;

typedef struct scree_contact
{
	scree_collidable a, b;
	scree_vec normal; // from a to b
	int color;        // in which the solver takes it: no two of a color from 0 to 62 share a body that can move; 63 is
	                  // that of hubs, bodies with more than 32 contacts. -1 for an overlap
	int count;        // 1 or 2
	scree_contact_point points[2];
	scree_body body_a, body_b; // of a and b; null for a collidable without a body
	uint64_t user_a, user_b;   // of a and b, as scree_collidable_set_user left them
} scree_contact;

// Writes up to capacity of the touching contacts that bodies answer to, in the order of the contact pool (equal on all
// devices), and how many there are.
static inline scree_status scree_world_get_contacts(scree_world* world, scree_contact* contacts, int capacity,
                                                    int* count);

// The same for the contacts of one body, in the same order. The device puts them together, and only they are read.
static inline scree_status scree_body_get_contacts(scree_world* world, scree_body body, scree_contact* contacts,
                                                   int capacity, int* count);

// The same for the pairs of which at least one collidable has no body. Impulses are zero. A pair is reported while the
// shapes are within the speculative distance (0.02 m): a separation of at most 0 is an overlap.
static inline scree_status scree_world_get_overlaps(scree_world* world, scree_contact* overlaps, int capacity,
                                                    int* count);

// ---------------------------------------------------------------------------------------------------------------
// Drawing
//
// What a renderer needs of every collidable, in one array that fits a vertex buffer: row k is the collidable of index
// k. scree_world_get_render_rows copies the rows to the host. Where scree_world_get_sharing says more than
// SCREE_SHARING_COPIED, they need not leave the device: it is given memory that OpenGL draws from, and
// scree_world_write_render_rows writes them there. The rows are the same, bit for bit. docs/share.md has an example.
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_render_row // 32 bytes
{
	scree_pose pose;   // of the attribute's shape in the world
	scree_vec center;  // from there to the body's center of mass, world axes, m
	int32_t attribute; // index of its handle; -1 where there is no collidable: skip the row
	int32_t body;      // index of its handle, which is 1 or more; -1 for none
} scree_render_row;

// Writes up to capacity rows of the world as it is now, and how many there are: one more than the highest index that a
// collidable had so far. rows may be null when capacity is 0.
SCREE_API scree_status scree_world_get_render_rows(scree_world* world, scree_render_row* rows, int capacity,
                                                   int* count);

// The way in which this world can share: that of its device, but SCREE_SHARING_OPENGL only when the world was made with
// a scree_world_def.opengl that the driver took.
SCREE_API scree_sharing scree_world_get_sharing(const scree_world* world);

// Memory that another interface allocated on the same device (scree_device.uuid) and exported as an opaque file
// descriptor; Vulkan can (VK_KHR_external_memory_fd), and OpenGL imports it as well (GL_EXT_memory_object_fd). The
// world takes over the descriptor when this succeeds. bytes is how much of the allocation is used, at least one row.
// Fails with SCREE_ERROR_NOT_SUPPORTED when scree_world_get_sharing does not say SCREE_SHARING_MEMORY or the driver
// refuses the memory. The memory is shared until it is replaced by another call, scree_world_unshare, the world's move
// to another device (of itself, where that is "auto"), or its end.
SCREE_API scree_status scree_world_share_memory(scree_world* world, int file_descriptor, size_t bytes);

// A buffer object of the context in scree_world_def.opengl, which is current on this thread, now and in
// scree_world_write_render_rows; bytes is the size of its storage, at least one row. It must outlive the sharing, and
// keep its storage. Fails with SCREE_ERROR_NOT_SUPPORTED when scree_world_get_sharing does not say SCREE_SHARING_OPENGL
// or the driver refuses the buffer.
SCREE_API scree_status scree_world_share_opengl(scree_world* world, uint32_t buffer, size_t bytes);

// Lets go of what was shared; null and worlds that share nothing are allowed.
SCREE_API void scree_world_unshare(scree_world* world);

// Writes the rows of the world as it is now into the shared memory, and how many there are into count. They are there
// when this returns. OpenGL must be done with the rows of before: wait for a fence behind the last draw. Fails with
// SCREE_ERROR_INVALID, and writes count all the same, when there are more rows than fit: share something larger.
SCREE_API scree_status scree_world_write_render_rows(scree_world* world, int* count);

// ---------------------------------------------------------------------------------------------------------------
// Versions
//
// The functions of the library behind those above that are static and inline, which pass the size that a struct has in
// the program. A binding for another language calls these. Members that the library does not know become 0.
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

#ifdef __cplusplus
}
#endif
#endif
