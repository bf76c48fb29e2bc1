// SPDX-License-Identifier: MIT
// scree.h -- the public interface of Scree, a 2D rigid body physics engine with bit-identical results on CPU and GPU.
//
// This header has the units, ranges and errors of all functions. docs/manual/README.md is the manual, in an order to read;
// the shortest program is examples/hello.c.
//
// Terms. "attribute" and "collidable" are the words of the paper by Girgis and Wells, GPGPU Acceleration for Video Game
// Physics Engines. An attribute is a shape with its material; Box2D calls it a shape definition (b2ShapeDef). A
// collidable is an attribute placed on a body; other engines call it a shape (Box2D v3), a fixture (Box2D v2), a geom
// (MuJoCo) or a collider (Unity, Rapier).
//
// Units are metres, kilograms, seconds and radians. Positive angles are counter-clockwise. A world can have another unit of
// length (scree_world_def.length_unit): "m" then stands for that unit, also in N (kg m/s^2), in results and in definitions.
//
// Threads. Only one thread at a time may use a world, except for the functions listed at scree_world_prepare_queries.
// Different threads may use different worlds at the same time. The threads of an engine can do the work of a world in
// place of those of the library: scree_world_def.tasks. See docs/manual/threads.md.
//
// Errors. Every function that can fail returns a scree_status. If the status is not SCREE_OK, nothing has changed,
// except where noted, and scree_error() returns one sentence that names the argument and its value. A null pointer, a
// number that is not finite and a value out of range give SCREE_ERROR_INVALID.
//
// Handles consist of an index and a generation. The all-zero handle is null. A null handle, or the handle of a
// destroyed object, gives SCREE_ERROR_STALE, except where noted. The body that a query or a mover ignores may have been
// destroyed.
//
// Ownership. The library copies all arguments, except where noted. The caller owns every world and destroys it; a world
// owns everything in it.
//
// Batches. A function with an array of handles or definitions and a count processes all entries or, on failure, none of
// them. The count is 0 to 16,777,216; an array may be null if the count is 0.
//
// Lists. A function with a capacity and a pointer to a count writes at most capacity entries and sets the count to the
// number of entries that exist. The array may be null if the capacity is 0.
//
// Changes (forces, velocities, poses, ...) are collected between steps and uploaded to the device as one batch. A
// function that reads state uploads pending changes first, so it returns what was written.
//
// Versions. New members are added at the end of definitions and results. A definition therefore starts with its size,
// which its default function sets; functions that fill a result receive its size (see the end of this header). Programs
// and libraries of different versions work together: a library refuses a definition in which a member that is newer
// than the library is not 0.
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

// Maximum number of vertices of a convex polygon. The narrow phase clips in registers; a larger limit would slow down
// every pair.
#define SCREE_MAX_VERTICES 8

// Largest magnitude of a coordinate, m. Larger coordinates are refused. At this distance, the spacing of floats is 8
// mm.
#define SCREE_MAX_COORDINATE 100000.0f

// ---------------------------------------------------------------------------------------------------------------
// Errors, hooks and version
// ---------------------------------------------------------------------------------------------------------------

// If SCREE_CHECKED is defined before this header is included, C++17 and C23 compilers warn of each status that a program
// ignores.
#if defined(SCREE_CHECKED) && ((defined(__cplusplus) && __cplusplus >= 201703L) || __STDC_VERSION__ >= 202000L)
#define SCREE_CHECKED_STATUS [[nodiscard]]
#else
#define SCREE_CHECKED_STATUS
#endif

typedef enum SCREE_CHECKED_STATUS scree_status
{
	SCREE_OK = 0,
	SCREE_ERROR_INVALID = 1,       // an argument is out of range; nothing changed
	SCREE_ERROR_STALE = 2,         // a handle is null, or its object was destroyed; nothing changed
	SCREE_ERROR_OUT_OF_MEMORY = 3, // host or device memory ran out; nothing changed, except if a step failed late
	SCREE_ERROR_NO_DEVICE = 4,     // the requested device does not exist or is not bit-identical to the CPU
	SCREE_ERROR_DEVICE_FAILED = 5, // the driver reported an error; see "Devices that fail"
	SCREE_ERROR_NOT_SUPPORTED = 6, // the device does not support this operation; nothing changed
	SCREE_ERROR_CONTACT_LIMIT = 7, // a step found more contacts than scree_world_def.contact_limit; nothing changed
	SCREE_ERROR_FILE = 8,          // a file cannot be opened, read or written
	SCREE_ERROR_DIFFERENT = 9,     // a replay has another result or another hash than its recording
} scree_status;

// Returns the message of the last failure on this thread, or an empty string. The library owns the string; it is valid
// until the next failing call on this thread.
SCREE_API const char* scree_error(void);

// Returns the name of a status ("ok", "invalid", ...), a constant string; "unknown" for any other number.
SCREE_API const char* scree_status_name(scree_status status);

// Returns the version of the library, major, minor and patch: "0.2.0", a constant string.
SCREE_API const char* scree_version(void);

typedef enum scree_log_level
{
	SCREE_LOG_INFO,
	SCREE_LOG_WARNING,
} scree_log_level;

// Process-wide hooks. A null member selects the default. The hooks are called on any thread that calls Scree, and on
// the background thread that opens a GPU for a world with device "auto".
typedef struct scree_hooks
{
	void* (*allocate)(size_t bytes, size_t alignment, void* context); // alignment: power of two; result may be null
	void (*release)(void* memory, void* context);
	void (*log)(scree_log_level level, const char* sentence, void* context); // default: prints warnings to stderr
	void (*assert_failed)(const char* expression, const char* file, int line, void* context); // default: prints, aborts
	void* context;
} scree_hooks;

// Installs a copy of hooks; null restores the defaults. Fails with SCREE_ERROR_INVALID while a world exists, or if only
// one of allocate and release is set.
SCREE_API scree_status scree_hooks_set(const scree_hooks* hooks);

// Function that is called for each failed call: name of the function, its status, and its sentence, which is valid until
// the hook returns. context: as given to scree_fail_hook_set.
typedef void (*scree_fail_hook)(const char* function, scree_status status, const char* sentence, void* context);

// Sets the process-wide hook for failed calls; null (default): none. A program whose hook ends the program needs no other
// check. Not while another thread is in a call of the library.
//
// The hook is called on the thread of the call, after the call has done everything else, once for each call of the program
// that returns another status than SCREE_OK, also for those within static inline functions. Calls that Scree makes itself, and
// failures from which it recovers, are not reported. The hook may call any function, also destroy the world of the failed
// call; failed calls within it are not reported. It must return or end the program: it must neither throw nor call
// longjmp. The call then returns its status, and scree_error() its sentence. Builds for WebAssembly have no hook.
SCREE_API void scree_fail_hook_set(scree_fail_hook hook, void* context);

// For libraries on top of Scree, whose failures are then reported as those of Scree itself. Between scree_call_begin and
// scree_call_end no failed call of this thread is reported. Each begin has one end, on the same thread; pairs may be nested.
SCREE_API void scree_call_begin(void);
// Ends a call of such a library, and returns `status`. function: name of the library's function. If the status is not SCREE_OK,
// scree_error() returns the sentence afterwards, and the hook is called, unless this pair lies in another one. sentence: may be
// null, for that of the last failure.
SCREE_API scree_status scree_call_end(const char* function, scree_status status, const char* sentence);

// Returns the host memory that the library currently uses, in bytes.
SCREE_API size_t scree_memory(void);

// ---------------------------------------------------------------------------------------------------------------
// Small types
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_vec
{
	float x, y;
} scree_vec;

// A rotation as cosine and sine; c * c + s * s is 1. Functions accept lengths from 0.9995 to 1.0005 and normalize them.
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
	scree_vec linear; // m/s, velocity of the center of mass
	float angular;    // rad/s
} scree_velocity;

typedef struct scree_box
{
	scree_vec lower, upper; // m
} scree_box;

// Returns the rotation by an angle in radians. The sine and cosine are Scree's own polynomials, which give the same
// bits on every machine. They are NaN for an infinite angle.
SCREE_API scree_rot scree_rot_make(float radians);

// Returns the angle of a rotation, in [-pi, pi] radians; 0 if cosine and sine are 0. The arc tangent is Scree's own
// polynomial.
SCREE_API float scree_rot_get_angle(scree_rot rotation);

// ---------------------------------------------------------------------------------------------------------------
// Devices
// ---------------------------------------------------------------------------------------------------------------

typedef enum scree_sharing // transfer of render rows to an OpenGL buffer, the slowest kind first
{
	SCREE_SHARING_COPIED, // through host memory: scree_world_get_render_rows, then an upload to the buffer by the user
	SCREE_SHARING_MEMORY, // cl_khr_external_memory with file descriptors: scree_world_share_memory
	SCREE_SHARING_OPENGL, // cl_khr_gl_sharing: scree_world_share_opengl
} scree_sharing;

// Returns "copied", "shared through external memory" or "shared with OpenGL", a constant string; "unknown" for any other
// number.
SCREE_API const char* scree_sharing_name(scree_sharing sharing);

typedef struct scree_device
{
	char name[128];    // valid as scree_world_def.device: "cpu", "opencl:NVIDIA H200"; the next of equal devices has a
	                   // number at the end: "opencl:NVIDIA H200 #2"
	char driver[128];  // platform and driver version; for the CPU: the widest lanes that it supports
	bool equal_bits;   // false if Scree cannot use the device, or if a test found results that differ from the CPU's;
	                   // true for a device that is not tested yet (`tested`)
	char reason[192];  // if equal_bits is false: the cause, and what helps; otherwise empty
	int compute_units; // CPU threads or OpenCL compute units
	uint64_t memory;   // bytes
	scree_sharing sharing; // fastest kind of sharing that the driver supports
	uint8_t uuid[16];      // device UUID as in OpenGL and Vulkan; zero if the driver does not report it
	bool tested;           // true: a verdict of scree_device_test on the device is stored, or it is the CPU
	bool own_rounding;     // if tested: integer code rounds quotients and roots, because the device rounds them wrongly
	bool keeps_denormals; // if tested: the device keeps numbers below 1.2e-38; others treat them as 0, which is allowed
	bool keeps_zeros; // if tested: operations with a constant 0 have the correct sign; others may not, which is allowed
	int tested_results; // number of float results that were compared with those of the CPU
	int tested_worlds;  // number of small worlds whose hashes were compared, each form of execution counted
} scree_device;

// Lists the devices of this machine, the CPU first. Writes at most capacity entries (devices may be null if capacity is
// 0) and sets count to the total number. If no OpenCL device is among them, scree_opencl_hint says what to install.
static inline scree_status scree_devices_get(scree_device* devices, int capacity, int* count);

// Tests whether the results of a device have the bits of those of the CPU, and stores the verdict: equal bits, or the
// first difference. A verdict that is stored already is replaced. device: "cpu", "opencl" or "opencl:NAME", as in
// scree_world_def. If results differ, fails with SCREE_ERROR_NO_DEVICE and the first difference.
//
// scree_world_create and scree_world_move test a device without a verdict, so that programs need not call this
// function. The test takes less than a second, but on a GPU the first build of the stages takes minutes. Verdicts are
// stored per version of the driver and of Scree in the folder of compiled programs (docs/manual/devices.md).
SCREE_API scree_status scree_device_test(const char* device);

// Returns one sentence that names what to install to get an OpenCL device, or an empty string if there is one. The
// library owns the string, which is valid until the next call.
SCREE_API const char* scree_opencl_hint(void);

// ---------------------------------------------------------------------------------------------------------------
// World
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_world scree_world;

typedef enum scree_window_system
{
	SCREE_WINDOW_EGL, // context: EGLContext; display: EGLDisplay
	SCREE_WINDOW_GLX, // context: GLXContext; display: Display*
	SCREE_WINDOW_WGL, // context: HGLRC; display: HDC
} scree_window_system;

typedef struct scree_opengl // an OpenGL context
{
	scree_window_system system;
	void *context, *display;
} scree_opengl;

// A part of the work of a step, which threads of the user run. argument: that of scree_tasks.enqueue.
typedef void scree_task(int index, void* argument);

// Functions of a pool of threads, which do the work of a world. They are called on the thread that calls Scree, and never
// by the functions listed at scree_world_prepare_queries.
typedef struct scree_tasks
{
	// Makes the pool call task(index, argument) once for each index from 0 to count - 1, on any threads, at the same time or
	// one after another, now or later. Returns a pointer for `finish`, which the library does not read. Null: all calls have
	// returned, or none will be made; then `finish` is not called, and the calling thread does the work that is left.
	// A task does not wait for another one, and it returns soon after the call of `finish` at the latest.
	void* (*enqueue)(scree_task* task, void* argument, int count, void* context);
	// Returns when all calls of the task have returned. Meanwhile it may run tasks on the calling thread. It must not
	// depend on the calling thread if that is one of the pool.
	void (*finish)(void* enqueued, void* context);
	void* context; // last argument of both functions
} scree_tasks;

typedef struct scree_world_def
{
	uint32_t size;           // set by scree_world_def_default
	scree_vec gravity;       // m/s^2, default (0, -10)
	const char* device;      // "auto" (default), "cpu", "opencl" or "opencl:NAME"; NAME: a part of the name of a
	                         // device or of its driver, in small or capital letters; "#2" at its end: the second of
	                         // several devices with equal names
	int threads;             // CPU worker threads, 0 to 64; 0 (default): one per core
	int lanes;               // CPU SIMD lanes: 1, 4, 8 or 16, if processor and build have them; 0 (default): the widest
	bool allow_unequal_bits; // true: a device whose results are not bit-identical is accepted; default false
	bool timings;            // true: each stage is measured (scree_world_get_timings), which slows down a GPU slightly;
	                         // default false
	// Stiffness of contacts as a frequency, Hz, 1e-3 to 1e6, default 40; limited to 1/6 of the substep rate. Deep contacts
	// have 1.03 times the limited frequency, but at most 2/3 of the step rate.
	float contact_hertz;
	float contact_damping_ratio; // 0 to 1e6, default 10
	float contact_push_speed;    // maximum speed at which overlapping pairs are pushed apart, m/s,
	                             // 0 to SCREE_MAX_COORDINATE, default 3
	float restitution_threshold; // m/s, >= 0, default 1; impacts below this speed do not bounce
	// Speed limit at the end of a step, m/s, 1e-3 to SCREE_MAX_COORDINATE, default 400. Rotation is limited to pi
	// radians per step and pi / 4 per substep.
	float max_speed;
	const scree_opengl* opengl; // null (default), or the context for scree_world_share_opengl. The struct is copied;
	                            // the context must outlive the world
	int body_capacity;          // initial capacity for bodies, 0 to 16,777,216; grows on demand; 0 (default): small
	int contact_capacity;       // initial capacity for contacts, 0 to 134,217,728; grows on demand; 0 (default): small
	int contact_limit;          // maximum number of contacts, 0 to 134,217,728, 300 bytes each; a step that finds more
	    // fails with SCREE_ERROR_CONTACT_LIMIT. 0 (default): 32 per collidable, at least 2 million
	// true: scree_contact.details has data of the last step. This costs up to 5 % of the time of the solve stage and 36
	// bytes per contact, and changes no motion. Default false.
	bool contact_details;
	float hit_speed;   // m/s, >= 0, default 1; a contact with a lower approach speed is not a scree_hit
	float hit_impulse; // N s, >= 0, default 0; a contact with a smaller impulse is not a scree_hit
	bool sleep;        // true (default): bodies at rest fall asleep (see "Sleep")
	// m/s, 1e-6 to 1e6, default 0.05. A body is at rest while no point of it moves faster. Its motion in each step
	// counts, not its velocity.
	float sleep_threshold;
	// s, 0 to INFINITY: maximum time that a call waits for the commands of an OpenCL device; then the call fails with
	// SCREE_ERROR_DEVICE_FAILED. 0 (default): 10 s for a GPU; no limit for a CPU, which is never lost and may compile
	// kernels at their first launch for minutes. INFINITY: no limit. See docs/manual/faults.md.
	float device_timeout;
	// Steps from one kept state (checkpoint) to the next, at least 0. If the OpenCL device of a world fails, the world
	// continues on the CPU from the last kept state (see "Devices that fail"). 0 (default): no state is kept. Has no effect
	// while a world is on the CPU.
	int recovery_interval;
	// Pool of threads that does the work of the world; then the library starts no thread for it, `threads` is the maximum
	// number of threads that work at the same time, the caller included, and device "auto" is "cpu". The struct is copied;
	// the pool must outlive the world. Both functions must be set. null (default): the library starts threads.
	const scree_tasks* tasks;
	// Units of length of the world per metre, 1e-3 to 1e6: 100 if 100 pixels are a metre. 0 (default) and 1: metres. All lengths of
	// the world are then in this unit: positions, sizes, speeds, gravity; forces in kg units/s^2, inertias in kg units^2, densities
	// in kg/units^2, and ranges too: sizes from 1 mm to SCREE_MAX_COORDINATE metres. Tolerances scale (scree_units), so the motion
	// is the one in metres, up to rounding; with a power of two it has the same bits. Thresholds and limits stay in metres, so their
	// defaults hold: contact_push_speed, restitution_threshold, max_speed, hit_speed, hit_impulse, sleep_threshold, also in
	// scree_tuning and scree_body_def. Shapes are made for metres: see scree_shape_scale. docs/manual/units.md
	float length_unit;
} scree_world_def;

// Returns a definition with the default values.
static inline scree_world_def scree_world_def_default(void);

// Creates a world. The caller owns *world and destroys it with scree_world_destroy. On failure *world is null. Fails
// with SCREE_ERROR_NO_DEVICE if def->device does not exist, or if its results differ from those of the CPU and
// allow_unequal_bits is false. An OpenCL device is tested before its first world (scree_device_test).
//
// With device "auto" the world starts on the CPU. scree_world_step moves the world to a GPU if steps are faster there,
// and back if steps are faster on the CPU, and logs both times (SCREE_LOG_INFO). A background thread opens the GPU once
// the world is large enough to gain from a GPU. A GPU that fails, or whose results differ from those of the CPU, is
// logged and not used. A move changes no bit of the world. docs/manual/auto.md has the rules.
SCREE_API scree_status scree_world_create(const scree_world_def* def, scree_world** world);

// Destroys a world and everything in it. world may be null.
SCREE_API void scree_world_destroy(scree_world* world);

// Returns the definition of a world as it is now: gravity and tuning may have changed since its creation. The pointers
// device, opengl and tasks have their default values.
static inline scree_status scree_world_get_def(const scree_world* world, scree_world_def* def);

// Advances a world by dt seconds (1e-9 to 1, or 0) in 1 to 64 substeps. Typical values are 1/60 and 4. Method: Erin
// Catto, Solver2D, 2024; Macklin et al., Small Steps in Physics Simulation, 2019.
//
// A step of dt 0 only detects contacts: contacts and overlaps begin and end at the current poses. Thus contacts,
// overlaps and scree_counters.penetration can be read as soon as a world is built or a body is placed. Poses,
// velocities, forces, targets and the impulses of existing contact points stay; a new contact has no impulse. The step
// counts in scree_counters.steps, and scree_traffic is zero after it.
//
// A step of dt 0 has the same bits on every device. Later steps have other bits than without the step of dt 0, because
// boxes and contacts were updated at another time.
//
// The number of contacts grows with the square of the number of bodies in one place. If it exceeds
// scree_world_def.contact_limit, the step fails with SCREE_ERROR_CONTACT_LIMIT; the message names the most crowded
// place and the number of collidables there. If memory for the contacts runs out, the step fails with
// SCREE_ERROR_OUT_OF_MEMORY. In both cases nothing has changed; move bodies apart or destroy some, and step again.
//
// A later failure (the device fails, or has no memory left for the solver) cannot be undone and breaks the world: every
// later call that uses it returns the same status, and it can only be destroyed, unless scree_world_def.recovery_interval
// is set (see "Devices that fail").
SCREE_API scree_status scree_world_step(scree_world* world, float dt, int substeps);

// Sets the gravity, m/s^2; its components must be finite.
SCREE_API scree_status scree_world_set_gravity(scree_world* world, scree_vec gravity);
// Returns scree_world_def.length_unit, 1 for metres; 0 if world is null. After scree_world_restore and scree_world_load
// it is the unit of the restored state.
SCREE_API float scree_world_get_length_unit(const scree_world* world);

typedef struct scree_constant // a constant of the library that contains a length
{
	const char* name;    // a constant string, as in the source: "SPECULATIVE_DISTANCE"
	float value;         // in metres: a world with length_unit u acts as if it were value times u to the power `power`
	int power;           // power of length
	const char* unit;    // "m", "m/s", "m^2", ..., a constant string
	const char* meaning; // a constant string
} scree_constant;

// Writes up to capacity constants with a length, and sets count to their number.
static inline scree_status scree_units(scree_constant* constants, int capacity, int* count);

// Returns the gravity, m/s^2.
SCREE_API scree_status scree_world_get_gravity(const scree_world* world, scree_vec* gravity);

typedef struct scree_tuning // the members of scree_world_def with the same names
{
	uint32_t size; // set by scree_world_get_tuning
	float contact_hertz;
	float contact_damping_ratio;
	float contact_push_speed;
	float restitution_threshold;
	float max_speed;
	bool sleep;
	float sleep_threshold;
} scree_tuning;

// Returns the parameters of the solver. Units and ranges are those of scree_world_def.
static inline scree_status scree_world_get_tuning(const scree_world* world, scree_tuning* tuning);

// Sets the parameters of the solver, from the next step on. To change a single parameter, get all of them with
// scree_world_get_tuning, change the member, and pass the struct.
SCREE_API scree_status scree_world_set_tuning(scree_world* world, const scree_tuning* tuning);

// Returns the name of the device on which the world currently runs, as in scree_device.name; an empty string if world is
// null. The world owns the string, which is valid until the world moves or is destroyed.
SCREE_API const char* scree_world_get_device(const scree_world* world);

// Moves a world to another device between two steps. With "cpu", "opencl" or "opencl:NAME" the world stays on that
// device; with "auto" scree_world_step chooses from now on. The world continues with the same bits: hash, handles,
// contacts, impulses and pending changes are kept. Threads, lanes, allow_unequal_bits and timings are those of the
// world's definition.
//
// A move opens the device (about 0.2 s for a GPU) and transfers about 1 kB per body; both devices hold the world
// meanwhile. On failure (SCREE_ERROR_NO_DEVICE, SCREE_ERROR_OUT_OF_MEMORY, ...) the world stays unchanged on its
// device. If the old device fails while the world is copied from it, the call fails with SCREE_ERROR_DEVICE_FAILED and
// breaks the world, as in scree_world_step.
SCREE_API scree_status scree_world_move(scree_world* world, const char* device);

// Devices that fail (docs/manual/faults.md). If scree_world_def.recovery_interval is N, above 0, the state of a world on an
// OpenCL device is kept in host memory every N steps, and so are the arguments of all calls since. A call during which the
// device fails makes no further call to the device, and logs one warning. It restores the kept state on the CPU, repeats the
// calls since, then does its own work there and returns its usual status. The world continues with the same bits. Handles,
// saves, recordings and lists that calls returned stay as they were; memory is no longer shared, and the device is "cpu", as
// after scree_world_move, which may move the world to a device again. If host memory for this is lacking, the call fails with
// SCREE_ERROR_DEVICE_FAILED, and the next call tries again. A device whose memory is too small for a step counts as failed.
// A state is kept earlier if the arguments of the calls need more memory than it. If memory for a state is lacking, the
// library logs a warning, and no call fails.

// Returns the number of CPU threads in use; 0 on an OpenCL device, or if world is null.
SCREE_API int scree_world_get_threads(const scree_world* world);
// Returns the number of CPU SIMD lanes in use; 0 on an OpenCL device, or if world is null.
SCREE_API int scree_world_get_lanes(const scree_world* world);

// Computes a 64-bit hash of all simulated state. Worlds with equal state have equal hashes on every device.
SCREE_API scree_status scree_world_get_hash(scree_world* world, uint64_t* hash);

// Snapshots (docs/manual/snapshots.md). A snapshot contains the whole state of a world: it is restored on any device, by this
// or a later version of the library, on any processor with little-endian numbers, and the world goes on with the same
// bits. Handles, user data and the events of the last step are as they were.

// Writes a snapshot. *bytes is memory of the world, valid until the next call of scree_world_snapshot with this world and
// until the world is destroyed; *size is its number of bytes. Pending changes of the user are in the snapshot. The world
// does not change. Fails with SCREE_ERROR_OUT_OF_MEMORY if there is no memory for the snapshot.
SCREE_API scree_status scree_world_snapshot(scree_world* world, const void** bytes, size_t* size);

// Replaces the content of a world by a snapshot, on the device of the world. Handles of objects that the snapshot lacks
// become invalid, and lists that the world returned too. Device, threads, lanes, timings and shared memory are those of
// the world. Fails with SCREE_ERROR_INVALID if the snapshot is damaged, not consistent or of a newer format, and with
// SCREE_ERROR_OUT_OF_MEMORY; the world is then unchanged. A failure of the device breaks the world, as in
// scree_world_step.
SCREE_API scree_status scree_world_restore(scree_world* world, const void* bytes, size_t size);

// Creates a world from a snapshot. def: device, threads, lanes, tasks, allow_unequal_bits, timings, opengl, capacities,
// device_timeout and recovery_interval of the world; its other members are those of the snapshot. The caller owns *world,
// which is null on failure. Fails as scree_world_create and scree_world_restore.
SCREE_API scree_status scree_world_create_from(const scree_world_def* def, const void* bytes, size_t size,
                                               scree_world** world);

// Creates a world with the state of another one. def: as in scree_world_create_from, or null for the members of the other
// world. The caller owns *clone, which is null on failure. Handles of the one are valid in the other. Fails as
// scree_world_create and scree_world_snapshot.
SCREE_API scree_status scree_world_clone(scree_world* world, const scree_world_def* def, scree_world** clone);

typedef struct scree_difference // a column of values in which two snapshots differ
{
	char column[64]; // "body.values", or "pool.pose+8" for a pool and a byte in its items: docs/design/snapshots.md
	char word[32];   // name of the word at this byte: "cos"; empty if it has none
	int count_a, count_b;      // number of items in each snapshot
	int items;                 // number of items that differ; those that one snapshot lacks differ
	int item;                  // first item that differs
	int offset, bytes;         // the part of its value that differs: position in the value and number of bytes, 1 to 8
	uint64_t value_a, value_b; // this part in each snapshot, the lowest byte first
} scree_difference;

// Compares two snapshots: writes up to capacity columns in which they differ, in the order of a snapshot, and sets count to
// their number. Fails with SCREE_ERROR_INVALID if a snapshot is damaged or of a newer format.
static inline scree_status scree_snapshots_compare(const void* a, size_t size_a, const void* b, size_t size_b,
                                                   scree_difference* differences, int capacity, int* count);

// Recordings (docs/manual/recording.md). A recording contains a snapshot, all later calls that change the world, with their
// arguments and results, and hashes of the world. It is repeated on any device, by this or a later version of the
// library, and the replay finds the first step that differs.

typedef struct scree_record_def
{
	uint32_t size;     // set by scree_record_def_default
	const char* path;  // file that is written; an existing file is replaced; null (default): the recording is in memory
	int hash_interval; // steps from one hash to the next, at least 1, default 60; 0: only the last hash is recorded
} scree_record_def;

// Returns a definition with the default values.
static inline scree_record_def scree_record_def_default(void);

// Begins to record a world; def may be null for the default. A file is written before each step, so that it contains the
// calls up to a step in which the program crashes. Calls that fail are not recorded. Recording changes no bit of the
// world. If memory for a recording runs out later, or its file cannot be written, a warning is logged, the recording ends
// with the record before, and scree_world_end_recording fails; other calls succeed. Fails with SCREE_ERROR_INVALID if the
// world is already recorded, with SCREE_ERROR_FILE if the file cannot be opened or written, and with
// SCREE_ERROR_NOT_SUPPORTED in WebAssembly.
SCREE_API scree_status scree_world_record(scree_world* world, const scree_record_def* def);

// Ends the recording of a world with the hash of the world, and closes the file. Works also after the device has failed,
// then without the hash. scree_world_destroy ends a recording too, without the hash. Fails with SCREE_ERROR_INVALID if the
// world is not recorded. Fails with SCREE_ERROR_OUT_OF_MEMORY or SCREE_ERROR_FILE if a call could not be recorded; the
// recording then ends before that call.
SCREE_API scree_status scree_world_end_recording(scree_world* world);

// Returns the recording in memory, up to now or up to its end. *bytes is memory of the world, valid until the next call that
// changes the world, until the next scree_world_record, and until the world is destroyed; *size is its number of bytes. Fails
// with SCREE_ERROR_INVALID if the world has no recording in memory.
SCREE_API scree_status scree_world_get_recording(const scree_world* world, const void** bytes, size_t* size);

typedef struct scree_replay scree_replay; // a recording that is being repeated

typedef struct scree_replay_info
{
	int64_t steps;    // number of steps in the recording
	int64_t step;     // number of steps that the replay has taken
	int64_t calls;    // number of calls in the recording, steps included
	int64_t hashes;   // number of hashes in the recording
	bool ended;       // false: the end of the recording is cut off, damaged or not yet written; it is read up to there
	size_t read;      // bytes up to the end, or up to the last whole record
	char version[16]; // version of the library that wrote the recording
	int64_t call;     // number of calls that the replay has repeated, steps included
	float dt;         // length of the last step that the replay has taken, s; 0 before the first step
	int substeps;     // its substeps; 0 before the first step
} scree_replay_info;

// Opens a recording, and checks all of its records. The caller owns *replay and closes it with scree_replay_close; on failure
// *replay is null. The bytes are not copied; they must outlive the replay. The end of a recording may be missing
// (scree_replay_info.ended). Fails with SCREE_ERROR_INVALID if the beginning is damaged, or if the recording has calls or a
// format of a later version.
SCREE_API scree_status scree_replay_open(const void* bytes, size_t size, scree_replay** replay);
// Closes a replay. replay may be null.
SCREE_API void scree_replay_close(scree_replay* replay);
// Returns what a recording contains.
static inline scree_status scree_replay_get_info(const scree_replay* replay, scree_replay_info* info);

// Creates a world in the state in which the recording began, and begins the replay. def: as in scree_world_create_from. The
// caller owns *world, which is null on failure. Fails as scree_world_create_from.
SCREE_API scree_status scree_replay_create_world(scree_replay* replay, const scree_world_def* def, scree_world** world);
// Restores a world to the state in which the recording began, and begins the replay again. Fails as scree_world_restore.
SCREE_API scree_status scree_replay_restore(scree_replay* replay, scree_world* world);

// Repeats the calls of a recording up to the next step and its hash. Sets stepped to false if no step was left; the calls
// after the last step have then been repeated. Fails with SCREE_ERROR_DIFFERENT and the number of the step if a call has
// other results than in the recording, if a call fails, or if the hash differs; stepped is then true if more of the
// recording is left, which the next call repeats. world: made by scree_replay_create_world or restored by
// scree_replay_restore, and not changed by other calls since.
SCREE_API scree_status scree_replay_step(scree_replay* replay, scree_world* world, bool* stepped);

// Saves, for rollback. A save is a copy of the state of a world in the memory of its device. It is faster than a snapshot,
// but belongs to its world: it ends with it. A world that moves to another device takes its saves along. A snapshot has no
// saves, and scree_world_restore keeps those of the world.
#define SCREE_SAVES 64 // number of saves that a world can have

// Saves a world. save: number of the save, from 0 to SCREE_SAVES - 1; an older save of this number is replaced. Pending
// changes of the user are in the save. What only the user changes, such as shapes, masses and joints, is copied if it
// changed since the last save. If it fails with SCREE_ERROR_OUT_OF_MEMORY, an older save of this number may be lost.
SCREE_API scree_status scree_world_save(scree_world* world, int save);

// Returns a world to the state of a save. The save stays. Handles and lists are as after scree_world_restore. Fails with
// SCREE_ERROR_INVALID if there is no save of this number, and with SCREE_ERROR_OUT_OF_MEMORY; the world is then unchanged.
// A failure of the device breaks the world, as in scree_world_step.
SCREE_API scree_status scree_world_load(scree_world* world, int save);

// Sets *bytes to the device memory of a save, in bytes, without the part that it shares with other saves; 0 if there is
// no save of this number. Fails with SCREE_ERROR_INVALID if the number is out of range.
SCREE_API scree_status scree_world_get_save_bytes(const scree_world* world, int save, uint64_t* bytes);

// Discards a save, so that other saves can use its memory. Has no effect if there is no save of this number. Fails with
// SCREE_ERROR_INVALID if the number is out of range.
SCREE_API scree_status scree_world_discard(scree_world* world, int save);

typedef struct scree_counters
{
	int bodies, dynamic_bodies;  // current numbers
	int collidables, attributes; // current numbers
	int contacts;                // pairs of collidables whose bounding boxes, enlarged by a margin, overlap
	int touching;                // contacts with contact points, also those of surfaces that are still apart
	int colors;                  // colors of the constraint graph in use (scree_contact.color)
	int spokes;                  // contacts of hubs (bodies with more than 32 contacts), which are solved together
	int updated_boxes;           // collidables whose enlarged box changed in the last step
	int new_contacts;            // contacts found in the last step
	int reallocations;           // buffer reallocations since the world was created
	int frozen_bodies;  // bodies frozen in the last step because their state became infinite or NaN. No force, impulse
	                    // or mass ratio that causes this is known. A body that reaches 1e8 m is stopped there
	int stopped_bodies; // bodies stopped in the last step because they would have tunneled through a static or dynamic
	                    // body, or because a kinematic body pressed them too far into such a body
	float penetration;  // deepest overlap at the start of the last step, m
	int64_t steps;      // steps taken, those of dt 0 included
	uint64_t device_bytes; // device memory of the pools, bytes
	// Widest gap of a joint at the start of the last step, m: the largest error of a distance that a rigid lock holds.
	// Locks whose lock_hertz is not 0, gears and pulleys do not count. In a world at rest, a gap of more than some mm
	// means that joints shake or are overloaded.
	float joint_gap;
	int asleep_bodies; // current number of bodies that sleep (see "Sleep")
} scree_counters;

// Returns the counters. bodies, dynamic_bodies, asleep_bodies, collidables and attributes are current; all others are
// those of the last step. touching also counts the contacts of sleeping bodies; spokes, penetration and joint_gap do
// not.
static inline scree_status scree_world_get_counters(scree_world* world, scree_counters* counters);

typedef struct scree_timings // milliseconds of the last step; zero unless scree_world_def.timings is set
{
	float step; // wall-clock time of scree_world_step, from the upload of changes until the device has finished
	float transform, broad_phase, narrow_phase, color, solve, finalize;
	float queries; // time of the last call that made queries, without transfers
} scree_timings;

// Returns the times of the last step. They are zero before the first step.
static inline scree_status scree_world_get_timings(scree_world* world, scree_timings* timings);

typedef struct scree_traffic // memory traffic of the solve stage in the last step
{
	int constraints;           // number of touching contacts that were solved
	int passes;                // number of passes over all constraints
	uint64_t constraint_bytes; // bytes read and written for constraints, which every pass reads from memory
	uint64_t body_bytes;       // bytes read and written for bodies; caches can serve many of them
} scree_traffic;

// Returns the number of bytes that the solve stage of the last step read and wrote. The numbers are computed from the
// algorithm, so they are the same on every device and independent of caches. The sum of both byte counts divided by
// scree_timings.solve (which is in ms) is the achieved bandwidth. All members are zero before the first step.
static inline scree_status scree_world_get_traffic(scree_world* world, scree_traffic* traffic);

// Measures the copy bandwidth of the world's device, in bytes per second, reads plus writes; a CPU uses all threads.
// Takes some milliseconds on a GPU and up to a second elsewhere. Allocates 512 MB meanwhile, or less if the device has
// less free memory. The world does not change.
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

// A shape in local coordinates: all points whose distance from the convex hull of the vertices is at most `radius`. The
// scree_shape_make_* functions fill all members. Functions that take a shape ignore its normals, centroid, area,
// inertia and reach, and compute them again.
typedef struct scree_shape
{
	scree_shape_kind kind;
	int count;                              // number of vertices: circle 1, capsule and segment 2, polygon 3 to 8
	float radius;                           // m; rounding radius of a polygon, 0 for a segment
	scree_vec vertices[SCREE_MAX_VERTICES]; // m; those of a polygon are convex and counter-clockwise
	scree_vec normals[SCREE_MAX_VERTICES];  // outward unit normal of the edge from vertex i to i + 1
	scree_vec centroid;                     // m
	float area;                             // m^2; 0 for a segment
	float inertia;                          // m^4: about the centroid, per unit of density
	float reach;                            // m: largest distance from the origin to a point of the shape
} scree_shape;

// Functions that make a shape. Lengths are in m. The functions fail with SCREE_ERROR_INVALID if a value is not finite,
// a size is below 1 mm, or a coordinate exceeds SCREE_MAX_COORDINATE. Bodies of 4 cm and more suit the solver best.
// Smaller bodies, down to 2 mm, also come to rest, but heaps of them need at least 4 substeps (docs/design/manifolds.md,
// "Small bodies").

// Makes a box around the origin, a polygon of 4 corners; half sizes in m.
SCREE_API scree_status scree_shape_make_box(float half_width, float half_height, scree_shape* shape);

// Makes a circle; center and radius in m.
SCREE_API scree_status scree_shape_make_circle(scree_vec center, float radius, scree_shape* shape);

// Makes a capsule: all points whose distance from the line between the points a and b is at most `radius`, in m. The
// points a and b are at least 1 mm apart.
SCREE_API scree_status scree_shape_make_capsule(scree_vec a, scree_vec b, float radius, scree_shape* shape);

// Makes a line without area between the points a and b (m), which are at least 1 mm apart.
SCREE_API scree_status scree_shape_make_segment(scree_vec a, scree_vec b, scree_shape* shape);

// Makes a convex polygon of 3 to 8 corners in clockwise or counter-clockwise order, rounded by radius (m; 0: sharp).
// Fails with SCREE_ERROR_INVALID if a corner is concave, collinear or coincident; scree_shape_make_hull drops such
// corners. A corner is coincident if its distance to another is less than a twentieth of the largest distance of two
// corners; this limit is at most 5 mm and at least 0.5 mm. A corner is collinear if its distance to the line between
// its neighbors is less than a tenth of that limit.
SCREE_API scree_status scree_shape_make_polygon(const scree_vec* corners, int count, float radius, scree_shape* shape);

// Makes the convex hull of 3 to 64 points (m), rounded by radius (m). Coincident points are merged and collinear
// corners dropped, by the limits of scree_shape_make_polygon. Fails with SCREE_ERROR_INVALID if the hull has fewer than
// 3 or more than 8 corners. Method: Barber, Dobkin, Huhdanpaa, The Quickhull Algorithm for Convex Hulls, 1996.
SCREE_API scree_status scree_shape_make_hull(const scree_vec* points, int count, float radius, scree_shape* shape);

// Transforms a shape: rotates it by pose.rotation, then translates it by pose.position. The shape may be changed in
// place: transformed may be equal to shape.
SCREE_API scree_status scree_shape_transform(const scree_shape* shape, scree_pose pose, scree_shape* transformed);

// Multiplies all lengths of a shape by a factor, 1e-9 to 1e9. The sizes of the result are not checked: a shape for a world with
// length_unit u may be made in metres and multiplied by u, with the ranges of metres. scaled may be equal to shape. Fails with
// SCREE_ERROR_INVALID if the shape is not valid in metres, or a result is not finite.
SCREE_API scree_status scree_shape_scale(const scree_shape* shape, float factor, scree_shape* scaled);

typedef struct scree_attribute_def
{
	uint32_t size; // set by scree_attribute_def_default
	scree_shape shape;
	float density;            // kg/m^2, 0 or 1e-6 to 1e9, default 1; scree_body_get_mass describes bodies without mass
	float friction;           // 0 to 1e6, default 0.6; a pair uses the geometric mean, at most 1000
	float restitution;        // 0 to 100, default 0; above 1 it adds speed; a pair uses the larger value
	float rolling_resistance; // lever arm as a fraction of the larger radius of the pair, 0 to 1e6, default 0
	float tangent_speed; // speed of a conveyor belt along the surface, m/s, within SCREE_MAX_COORDINATE, default 0;
	                     // clockwise around the shape if positive, so that a body on top moves to the right
	// A vector other than 0 makes the shape a one-way platform: it is solid only for bodies that come from the side to
	// which the vector points. The vector is in the frame of the shape, at least 1e-3 long; default 0. docs/manual/rules.md
	// has the rules.
	scree_vec one_way;
	int material; // 0 to 255, default 0: the material for scree_world_set_material_pair
} scree_attribute_def;

// Returns a definition with the default values and a box 1 m wide and high.
static inline scree_attribute_def scree_attribute_def_default(void);

// Creates an attribute, or returns the existing one with equal values. Attributes are immutable. An attribute exists
// until it or its world is destroyed. A program needs no attribute for a shape that it gives with its body
// (scree_body_create_with_shape): collidables then own theirs, and never share one of scree_attribute_create.
SCREE_API scree_status scree_attribute_create(scree_world* world, const scree_attribute_def* def,
                                              scree_attribute* attribute);

// Reverts one scree_attribute_create. An attribute that was created n times, with equal values, is destroyed by the
// n-th call. That call fails with SCREE_ERROR_INVALID while a collidable uses the attribute. The handle then stays stale,
// even if a later attribute has its index. An attribute that collidables own is refused with SCREE_ERROR_INVALID: it ends
// with the last of them.
SCREE_API scree_status scree_attribute_destroy(scree_world* world, scree_attribute attribute);

// Returns true if the handle refers to an existing attribute.
SCREE_API bool scree_attribute_is_valid(const scree_world* world, scree_attribute attribute);

// Writes the handles of up to capacity attributes in ascending index order, also of those that collidables own, and sets count to
// their number.
SCREE_API scree_status scree_world_get_attributes(const scree_world* world, scree_attribute* attributes, int capacity,
                                                  int* count);

// Returns the values with which an attribute was created.
static inline scree_status scree_attribute_get_def(const scree_world* world, scree_attribute attribute,
                                                   scree_attribute_def* def);

typedef struct scree_surface // values of scree_attribute_def, with the same units, ranges and defaults
{
	uint32_t size; // set by scree_surface_default
	float friction, restitution, rolling_resistance, tangent_speed;
} scree_surface;

// Returns a surface with the default values: friction 0.6, all others 0.
static inline scree_surface scree_surface_default(void);

typedef struct scree_material_pair // surface values of a pair of materials, which replace those of their attributes
{
	uint32_t size;     // set by scree_material_pair_default
	float friction;    // 0 to 1e6; values above 1000 act as 1000; NaN (default): the attributes' mixing rule
	float restitution; // 0 to 100; NaN (default): the attributes' mixing rule
	bool ignored;      // true: collidables of the two materials pass through each other; default false
	// Relative speed of the two surfaces, m/s, within SCREE_MAX_COORDINATE, clockwise around each of the two shapes if
	// positive; NaN (default): the sum of the tangent speeds of the attributes.
	float tangent_speed;
} scree_material_pair;

// Returns a pair that changes nothing: NaN for all values, not ignored.
static inline scree_material_pair scree_material_pair_default(void);

// Sets the surface values for contacts between two materials (0 to 255; they may be equal); the order of the two makes
// no difference. A null pair restores the values of the attributes. The change takes effect in the next step, also for
// existing contacts: the end of a contact that becomes ignored is an event, and a new contact begins when the pair is
// no longer ignored.
SCREE_API scree_status scree_world_set_material_pair(scree_world* world, int material_a, int material_b,
                                                     const scree_material_pair* pair);

// Returns the values that were set for two materials (0 to 255), or those of scree_material_pair_default.
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
// only the group decides: a positive group always allows contact, a negative one never.
typedef struct scree_filter
{
	uint64_t category; // default 1
	uint64_t mask;     // default all bits
	int32_t group;     // default 0
} scree_filter;

// Bits of scree_collidable_def.reports: the kinds of events that are listed. An event of a contact is listed if at
// least one of the two collidables has the bit.
enum
{
	SCREE_REPORT_TOUCHES = 1,  // scree_events.touches_began, touches_ended
	SCREE_REPORT_HITS = 2,     // scree_events.hits
	SCREE_REPORT_APPROVAL = 4, // scree_events.approvals: new contacts are pending until scree_world_approve_contacts
};

// Bits of scree_body_def.sensor and scree_collidable_def.sensor: the kinds of collidables that a sensor detects. A
// sensor touches nothing and stops nothing; it reports the collidables that overlap it (scree_events.visits_began,
// scree_collidable_get_visits). A sensor may belong to a body of any type, or to no body. It does not detect
// collidables of its own body. It adds to the mass of its body unless its density is 0. Filters apply to sensors.
// A sensor also detects bodies that a joint or an excluded pair keeps from touching its body.
enum
{
	SCREE_SENSOR_MOVING = 1,  // collidables of dynamic and kinematic bodies
	SCREE_SENSOR_STATIC = 2,  // collidables of static bodies, or without a body
	SCREE_SENSOR_SENSORS = 4, // other sensors
};

typedef struct scree_body_def
{
	uint32_t size;             // set by scree_body_def_default
	scree_body_type type;      // default SCREE_BODY_DYNAMIC
	scree_pose pose;           // pose of the body's origin; default: the world's origin, not rotated
	scree_velocity velocity;   // velocity of the center of mass, components within SCREE_MAX_COORDINATE; default 0
	float gravity_scale;       // default 1
	float linear_damping;      // 1/s, >= 0, default 0
	float angular_damping;     // 1/s, >= 0, default 0
	uint32_t locks;            // bits of SCREE_LOCK_*; default 0
	scree_attribute attribute; // if not null, the body gets one collidable with this attribute, at the body's origin
	scree_filter filter;       // filter of that collidable
	uint64_t user;             // user data of the body and of that collidable, not simulated; default 0
	bool disabled;             // true: the body starts disabled (scree_body_set_enabled); default false
	uint32_t reports;          // bits of SCREE_REPORT_* for that collidable; default 0
	uint32_t sensor;           // bits of SCREE_SENSOR_* for that collidable; default 0: it is not a sensor
	bool asleep;               // true: a dynamic body starts asleep, without its velocity, if scree_world_def.sleep is
	                           // set and stays_awake is not (see "Sleep"); default false
	bool stays_awake;          // true: the body and its island never fall asleep; default false
	float sleep_threshold;     // m/s, 0 to 1e6: as in scree_world_def; 0 (default): that of the world
} scree_body_def;

// Returns a definition with the default values, without a collidable.
static inline scree_body_def scree_body_def_default(void);

// Returns the filter that allows contact with all collidables: category 1, all bits of the mask, group 0.
SCREE_API scree_filter scree_filter_default(void);

// Creates count bodies from count definitions and writes their handles to bodies (may be null). On failure no body is
// created. A world holds at most 16,777,216 bodies.
SCREE_API scree_status scree_bodies_create(scree_world* world, const scree_body_def* defs, int count,
                                           scree_body* bodies);

// Creates one body and writes its handle to *body (may be null).
SCREE_API scree_status scree_body_create(scree_world* world, const scree_body_def* def, scree_body* body);

// Creates count bodies, each with one collidable of the shape and surface shapes[k], at the body's origin. The collidable
// owns its attribute: no handle of it is needed, equal ones share a slot, and it ends when the last collidable that uses
// it is destroyed or gets another. defs[k].attribute must be null; filter, user data, reports and sensor of defs[k] are
// those of the collidable too. On failure no body and no attribute is created.
SCREE_API scree_status scree_bodies_create_with_shapes(scree_world* world, const scree_body_def* defs,
                                                       const scree_attribute_def* shapes, int count,
                                                       scree_body* bodies);
// Creates one body with a shape, as above, and writes its handle to *body (may be null).
SCREE_API scree_status scree_body_create_with_shape(scree_world* world, const scree_body_def* def,
                                                    const scree_attribute_def* shape, scree_body* body);

// Create one body with one shape in one call. They use the default values of scree_body_def and scree_attribute_def,
// make the shape as the scree_shape_make_ function with that name does, and call scree_body_create_with_shape. user: user
// data of the body and of its collidable. body may be null. They fail as these two functions do, whose names are in the
// message; on failure nothing is created.
static inline scree_status scree_body_create_box(scree_world* world, scree_body_type type, scree_pose pose,
                                                 float half_width, float half_height, uint64_t user, scree_body* body);
static inline scree_status scree_body_create_circle(scree_world* world, scree_body_type type, scree_pose pose,
                                                    float radius, uint64_t user, scree_body* body);
static inline scree_status scree_body_create_capsule(scree_world* world, scree_body_type type, scree_pose pose,
                                                     scree_vec a, scree_vec b, float radius, uint64_t user,
                                                     scree_body* body);
static inline scree_status scree_body_create_polygon(scree_world* world, scree_body_type type, scree_pose pose,
                                                     const scree_vec* vertices, int count, float radius, uint64_t user,
                                                     scree_body* body);

// Destroys bodies with their collidables, contacts, joints and fields. On failure, for instance because a body is twice
// in the batch, no body is destroyed.
SCREE_API scree_status scree_bodies_destroy(scree_world* world, const scree_body* bodies, int count);
// Destroys one body, as above.
SCREE_API scree_status scree_body_destroy(scree_world* world, scree_body body);

// Returns true if the handle refers to an existing body.
SCREE_API bool scree_body_is_valid(const scree_world* world, scree_body body);

// Writes the handles of up to capacity bodies in ascending index order, and sets count to the number of bodies.
SCREE_API scree_status scree_world_get_bodies(const scree_world* world, scree_body* bodies, int capacity, int* count);

// Batches. Each function takes count handles and count values. On failure nothing has changed. If a body is twice in
// the batch, both values are applied, in order. Forces, torques and impulses act on dynamic bodies only and may have
// any finite value; points are within SCREE_MAX_COORDINATE.

// Adds forces in N, which act at the centers of mass during the next step.
SCREE_API scree_status scree_bodies_apply_forces(scree_world* world, const scree_body* bodies, const scree_vec* forces,
                                                 int count);

// Adds torques in N m, which act during the next step.
SCREE_API scree_status scree_bodies_apply_torques(scree_world* world, const scree_body* bodies, const float* torques,
                                                  int count);

// Applies impulses in N s at the centers of mass, immediately.
SCREE_API scree_status scree_bodies_apply_impulses(scree_world* world, const scree_body* bodies,
                                                   const scree_vec* impulses, int count);

// Applies angular impulses in N m s, immediately.
SCREE_API scree_status scree_bodies_apply_angular_impulses(scree_world* world, const scree_body* bodies,
                                                           const float* impulses, int count);

// Adds forces in N, which act at world points (m) during the next step.
SCREE_API scree_status scree_bodies_apply_forces_at(scree_world* world, const scree_body* bodies,
                                                    const scree_vec* forces, const scree_vec* points, int count);

// Applies impulses in N s at world points (m), immediately.
SCREE_API scree_status scree_bodies_apply_impulses_at(scree_world* world, const scree_body* bodies,
                                                      const scree_vec* impulses, const scree_vec* points, int count);

// Sets the linear and the angular velocities. Components are within SCREE_MAX_COORDINATE. Locked components become 0,
// and a static body stays at rest.
SCREE_API scree_status scree_bodies_set_velocities(scree_world* world, const scree_body* bodies,
                                                   const scree_velocity* velocities, int count);
// Sets the linear velocities, m/s; angular velocities stay.
SCREE_API scree_status scree_bodies_set_linear_velocities(scree_world* world, const scree_body* bodies,
                                                          const scree_vec* velocities, int count);
// Sets the angular velocities, rad/s; linear velocities stay.
SCREE_API scree_status scree_bodies_set_angular_velocities(scree_world* world, const scree_body* bodies,
                                                           const float* velocities, int count);

// Teleports bodies: sets the poses of their origins, in m, within SCREE_MAX_COORDINATE. Velocities do not change.
SCREE_API scree_status scree_bodies_set_poses(scree_world* world, const scree_body* bodies, const scree_pose* poses,
                                              int count);

// Sets targets: the poses that kinematic bodies have at the end of the next step with dt > 0. Targets are poses of the
// bodies' origins, within SCREE_MAX_COORDINATE. Static and dynamic bodies are refused with SCREE_ERROR_INVALID. During
// that step the body has the velocity that moves it to its target, so that it pushes and carries the bodies that it
// touches. The body takes the shorter rotation (half a turn is counter-clockwise). At the end it is exactly at its
// target and at rest: its velocity is 0 before that step and after it.
//
// Locked motion stays locked. A body that would exceed max_speed, or rotate further than one step allows
// (scree_world_def.max_speed), still reaches its target, but pushes other bodies with the limited velocity only.
//
// A second target replaces the first. Setting the velocity, changing the type or destroying the body drops the target;
// scree_body_set_pose changes only the pose from which the body moves to the target. The target is kept by a step of dt
// 0, by a step that fails without changes, and by steps while the body is disabled.
SCREE_API scree_status scree_bodies_set_targets(scree_world* world, const scree_body* bodies, const scree_pose* poses,
                                                int count);

// Returns the poses of the bodies' origins. The world also stores the remainder of rounding each position to float,
// which no function returns. Setting a pose that was read may therefore move a body by half the spacing of floats.
SCREE_API scree_status scree_bodies_get_poses(scree_world* world, const scree_body* bodies, scree_pose* poses,
                                              int count);

// Returns the velocities of the centers of mass.
SCREE_API scree_status scree_bodies_get_velocities(scree_world* world, const scree_body* bodies,
                                                   scree_velocity* velocities, int count);

typedef struct scree_body_state
{
	scree_pose pose; // pose of the body's origin
	scree_velocity velocity;
	bool asleep;
} scree_body_state;

// Writes the states of up to capacity bodies in ascending index order, and their handles to bodies (may be null). Sets
// count to the number of bodies.
SCREE_API scree_status scree_world_get_states(scree_world* world, scree_body* bodies, scree_body_state* states,
                                              int capacity, int* count);

// Writes the poses of up to capacity bodies' origins between the last two steps, for drawing, in ascending index order,
// and their handles to bodies (may be null). Sets count to the number of bodies. alpha is the fraction of the last step,
// 0 to 1, such as scree_clock.alpha: 0 gives the poses before the step, 1 exactly those that scree_world_get_states
// returns. Between them a center of mass moves on a straight line, and a body turns about it at constant speed; after
// half a turn or more in one step the angle between the two rotations counts.
//
// A body stands at its current pose if it is static, asleep, disabled, new, or if its pose was set since the last step:
// a teleport is a jump. So do all bodies after scree_world_load, scree_world_restore, scree_world_create_from,
// scree_world_clone and scree_world_move, until the next step. The last step is the last with dt > 0. The call changes
// nothing, and gives the same bits on every device.
SCREE_API scree_status scree_world_get_interpolated(scree_world* world, float alpha, scree_body* bodies,
                                                    scree_pose* poses, int capacity, int* count);

// The functions of one body below have the units, ranges and effects of the batch functions with the same names.

// Adds a force in N at the center of mass, for the next step.
SCREE_API scree_status scree_body_apply_force(scree_world* world, scree_body body, scree_vec force);
// Adds a force in N at a world point (m), for the next step.
SCREE_API scree_status scree_body_apply_force_at(scree_world* world, scree_body body, scree_vec force, scree_vec point);
// Adds a torque in N m, for the next step.
SCREE_API scree_status scree_body_apply_torque(scree_world* world, scree_body body, float torque);
// Applies an impulse in N s at the center of mass, immediately.
SCREE_API scree_status scree_body_apply_impulse(scree_world* world, scree_body body, scree_vec impulse);
// Applies an impulse in N s at a world point (m), immediately.
SCREE_API scree_status scree_body_apply_impulse_at(scree_world* world, scree_body body, scree_vec impulse,
                                                   scree_vec point);
// Applies an angular impulse in N m s, immediately.
SCREE_API scree_status scree_body_apply_angular_impulse(scree_world* world, scree_body body, float impulse);
// Sets the linear and the angular velocity.
SCREE_API scree_status scree_body_set_velocity(scree_world* world, scree_body body, scree_velocity velocity);
// Returns the velocity of the center of mass.
SCREE_API scree_status scree_body_get_velocity(scree_world* world, scree_body body, scree_velocity* velocity);
// Sets the linear velocity, m/s; the angular velocity stays.
SCREE_API scree_status scree_body_set_linear_velocity(scree_world* world, scree_body body, scree_vec velocity);
// Sets the angular velocity, rad/s; the linear velocity stays.
SCREE_API scree_status scree_body_set_angular_velocity(scree_world* world, scree_body body, float velocity);
// Sets the pose that a kinematic body has at the end of the next step with dt > 0; see scree_bodies_set_targets.
SCREE_API scree_status scree_body_set_target(scree_world* world, scree_body body, scree_pose pose);
// Teleports a body; its velocity does not change.
SCREE_API scree_status scree_body_set_pose(scree_world* world, scree_body body, scree_pose pose);
// Returns the pose of the body's origin.
SCREE_API scree_status scree_body_get_pose(scree_world* world, scree_body body, scree_pose* pose);

// Converts a point (m, within SCREE_MAX_COORDINATE) from the body's frame to the world.
SCREE_API scree_status scree_body_get_world_point(scree_world* world, scree_body body, scree_vec local,
                                                  scree_vec* point);
// Converts a point (m, within SCREE_MAX_COORDINATE) from the world to the body's frame.
SCREE_API scree_status scree_body_get_local_point(scree_world* world, scree_body body, scree_vec point,
                                                  scree_vec* local);

// Returns the velocity (m/s) of the body at a world point (m).
SCREE_API scree_status scree_body_get_point_velocity(scree_world* world, scree_body body, scree_vec point,
                                                     scree_vec* velocity);

// Returns a definition of the body as it is now: its type, pose, velocity, settings and user data, and whether it is
// disabled. A body that is created from this definition has no collidable: attribute is null, and filter, reports
// and sensor have their defaults. The definition contains neither a mass set by scree_body_set_mass, nor the target of a
// kinematic body, nor forces that were applied since the last step. scree_body_create refuses it if the body has moved
// beyond SCREE_MAX_COORDINATE or is faster than a new body may be.
static inline scree_status scree_body_get_def(scree_world* world, scree_body body, scree_body_def* def);

// Settings of one body, with the units and ranges of scree_body_def. Changes are uploaded with the next batch.

// Changes the type. The contacts of the body end and begin again, its target is dropped, and a body that becomes static
// stops.
SCREE_API scree_status scree_body_set_type(scree_world* world, scree_body body, scree_body_type type);
// Returns the type.
SCREE_API scree_status scree_body_get_type(const scree_world* world, scree_body body, scree_body_type* type);
// Sets the linear and the angular damping, 1/s, at least 0.
SCREE_API scree_status scree_body_set_damping(scree_world* world, scree_body body, float linear, float angular);
// Returns the linear and the angular damping, 1/s.
SCREE_API scree_status scree_body_get_damping(const scree_world* world, scree_body body, float* linear, float* angular);
// Sets the factor of gravity, any finite value.
SCREE_API scree_status scree_body_set_gravity_scale(scree_world* world, scree_body body, float scale);
// Returns the factor of gravity.
SCREE_API scree_status scree_body_get_gravity_scale(const scree_world* world, scree_body body, float* scale);
// Sets the locked motions, bits of SCREE_LOCK_*.
SCREE_API scree_status scree_body_set_locks(scree_world* world, scree_body body, uint32_t locks);
// Returns the locked motions, bits of SCREE_LOCK_*.
SCREE_API scree_status scree_body_get_locks(const scree_world* world, scree_body body, uint32_t* locks);
// Sets the user data of the body; the user data of its collidables stays.
SCREE_API scree_status scree_body_set_user(scree_world* world, scree_body body, uint64_t user);
// Returns the user data of the body.
SCREE_API scree_status scree_body_get_user(const scree_world* world, scree_body body, uint64_t* user);

// Enables or disables bodies. The simulation ignores a disabled body: it does not move, nothing touches it, forces and
// gravity do not act on it, and its collidables are not drawn (scree_render_row.attribute is -1). Its contacts end as
// if it were destroyed. Everything else is kept and can still be read and set: velocity, pose, collidables. Forces
// applied to a disabled body are lost. When the body is enabled, it continues with the kept velocity, and its contacts
// are new. A disabled body counts in scree_counters.bodies. Enabling an enabled body changes nothing, nor does
// disabling a disabled one. On failure no body of the batch changes.
SCREE_API scree_status scree_bodies_set_enabled(scree_world* world, const scree_body* bodies, const bool* enabled,
                                                int count);
// Enables or disables one body, as above.
SCREE_API scree_status scree_body_set_enabled(scree_world* world, scree_body body, bool enabled);

// Returns true if the body exists and is enabled.
SCREE_API bool scree_body_is_enabled(const scree_world* world, scree_body body);

// Adds (true) or removes (false) excluded pairs: two different bodies that never touch each other, regardless of their
// filters; the order of the two makes no difference. If an excluded pair touches now, the touch ends in the next step,
// with its event. When a pair is removed, its contacts begin again. Bodies that a joint keeps from touching do not
// touch even then. Destroying a body removes its pairs. A world holds up to 16,777,216 pairs. On failure no pair of the
// batch changes.
SCREE_API scree_status scree_bodies_set_excluded(scree_world* world, const scree_body* a, const scree_body* b,
                                                 const bool* excluded, int count);
// Adds or removes one excluded pair, as above.
SCREE_API scree_status scree_body_set_excluded(scree_world* world, scree_body body, scree_body other, bool excluded);

// Returns true if both bodies exist and are an excluded pair. Pairs that only a joint keeps from touching do not count.
SCREE_API bool scree_body_is_excluded(const scree_world* world, scree_body body, scree_body other);

// Writes up to capacity bodies that form an excluded pair with a body, in ascending index order, and sets count to
// their number.
SCREE_API scree_status scree_body_get_excluded(scree_world* world, scree_body body, scree_body* others, int capacity,
                                               int* count);

// Sleep. If scree_world_def.sleep is set, bodies at rest fall asleep: they have velocity 0, do not move, and cost less.
// Dynamic bodies that touch or are joined form an island, and an island falls asleep and wakes as a whole. Static and
// kinematic bodies never sleep and connect nothing, so crates side by side on the ground are islands of their own.
// docs/manual/sleep.md has more.
//
// An island falls asleep when all of its bodies have been at rest (scree_world_def.sleep_threshold) for 0.5 s, or up to
// 8 steps later. It stays awake while scree_body_def.stays_awake is set for one of its bodies, while it touches or is
// joined to a kinematic body that moves, and while a motor moves its bodies with at least half of the motor's speed.
//
// An island wakes for these reasons, in the next step after a call, otherwise in the step in which the reason occurs:
// - a call changes one of its bodies: a force, impulse or velocity other than 0, a pose, mass, type, damping, gravity
//   scale, lock, collidable, attribute, surface, filter, exclusion or joint; or the body is enabled or disabled;
// - a body that is awake, or a kinematic body that moves, begins to touch it;
// - a static or kinematic body that it touches, or to which it is joined, begins to move, or the user moves, changes or
//   destroys it;
// - one of its bodies is in the box around a field that is created, changed or destroyed, or moves with a body. A field
//   that acts everywhere wakes all bodies, and so does destroying, enabling or disabling a body with fields;
// - gravity changes, or a call sets the tuning or a pair of materials: these wake all bodies.
// Reading, queries and moves to another device wake nothing; nor does a new static body, even if it touches the island.
// A setting that is set to the value that it has wakes nothing: damping, gravity scale, locks, type, enabling,
// filter, attribute, surface, all settings of joints, gravity, tuning, pairs of materials. So a program may set these in
// each step.
//
// Contacts and joints of sleeping bodies keep their impulses and can be read. Queries and sensors find sleeping bodies
// as others. Bodies that were created asleep begin to report their touches (scree_events) when they wake.

// Wakes bodies with their islands (true), or puts their islands to sleep in the next step with dt > 0 (false), even if
// they move. An island stays awake in spite of that if:
// - since the last step a call has moved or woken another of its bodies, and no later call put that body to sleep;
// - it was asleep, and since the last step a call has moved one of its bodies;
// - in that step it begins to touch something, or something other than a call that changes its bodies would wake it;
// - scree_body_def.stays_awake is set for one of its bodies.
// Does nothing for static, kinematic and disabled bodies, nor in a world that does not sleep.
SCREE_API scree_status scree_bodies_set_awake(scree_world* world, const scree_body* bodies, const bool* awake,
                                              int count);
// Wakes one body, or puts it to sleep, as scree_bodies_set_awake does.
SCREE_API scree_status scree_body_set_awake(scree_world* world, scree_body body, bool awake);
// Does the same as scree_bodies_set_awake for all bodies with a collidable that overlaps a box, which is at least 2 mm
// wide and high.
SCREE_API scree_status scree_world_set_box_awake(scree_world* world, scree_box box, bool awake);
// Does the same as scree_bodies_set_awake for all bodies of a world.
SCREE_API scree_status scree_world_set_awake(scree_world* world, bool awake);

// Returns whether bodies are awake. A body whose island wakes in the next step counts as awake. Static, kinematic and
// disabled bodies are always awake.
SCREE_API scree_status scree_bodies_get_awake(scree_world* world, const scree_body* bodies, bool* awake, int count);
// Returns whether one body is awake, as scree_bodies_get_awake does.
SCREE_API scree_status scree_body_get_awake(scree_world* world, scree_body body, bool* awake);

// Sets scree_body_def.sleep_threshold, m/s, 0 to 1e6. Wakes nothing.
SCREE_API scree_status scree_body_set_sleep_threshold(scree_world* world, scree_body body, float threshold);
// Returns scree_body_def.sleep_threshold, m/s.
SCREE_API scree_status scree_body_get_sleep_threshold(const scree_world* world, scree_body body, float* threshold);
// Sets scree_body_def.stays_awake; true wakes the body.
SCREE_API scree_status scree_body_set_stays_awake(scree_world* world, scree_body body, bool stays_awake);
// Returns scree_body_def.stays_awake.
SCREE_API scree_status scree_body_get_stays_awake(const scree_world* world, scree_body body, bool* stays_awake);

typedef struct scree_mass
{
	float mass;       // kg, 0 for static and kinematic bodies
	float inertia;    // kg m^2 about the center of mass
	scree_vec center; // center of mass in the body's frame, m
} scree_mass;

// Returns the mass of a body, which is computed from the densities of its collidables. A dynamic body whose mass would
// be zero, because all densities are 0 or because it has no collidable, gets 1 kg and cannot rotate.
SCREE_API scree_status scree_body_get_mass(const scree_world* world, scree_body body, scree_mass* mass);

// Overrides the computed mass of a dynamic body until a collidable is added or removed, or gets an attribute with
// another shape or density. The override is kept, but has no effect, while the body is static or kinematic. When the
// center of mass changes, each point of the body keeps its velocity: the velocity of the new center is v + w x (new -
// old), where v is the velocity of the old center and w the angular velocity.
//
// Range: mass 1e-15 to 1e30 kg; inertia 1e-20 to 1e30 kg m^2, or 0 for a body that cannot rotate; center within
// SCREE_MAX_COORDINATE. A step uses at least m r^2 / 1000 (but not over 1.27e30 kg m^2) for the inertia, because with
// less, floats have too few digits for the impulses of joints and contacts. m is the mass; r is the largest distance
// from the center of mass to the anchor of a joint or to the end of a solid shape. Fails with SCREE_ERROR_INVALID for
// a body that is not dynamic.
SCREE_API scree_status scree_body_set_mass(scree_world* world, scree_body body, scree_mass mass);
// Overrides the masses of a batch of bodies, as above. On failure no mass changes.
SCREE_API scree_status scree_bodies_set_masses(scree_world* world, const scree_body* bodies, const scree_mass* masses,
                                               int count);
// Returns the mass that overrides the computed one of a body, also while it has no effect; all zeros if there is none.
SCREE_API scree_status scree_body_get_own_mass(const scree_world* world, scree_body body, scree_mass* mass);

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
	uint32_t size;             // set by scree_collidable_def_default
	scree_attribute attribute; // not null, except in functions that take a shape
	scree_body body;           // null (default): the collidable belongs to no body, and only reports overlaps
	scree_pose pose; // pose in the body's frame, or in the world without a body; position within SCREE_MAX_COORDINATE
	scree_filter filter;
	uint64_t user;    // user data, not simulated; default 0
	uint32_t reports; // bits of SCREE_REPORT_*; default 0
	uint32_t sensor;  // bits of SCREE_SENSOR_*: the kinds of collidables that it detects; default 0: it is not a sensor
} scree_collidable_def;

// Returns a definition with the default values, a null attribute and a null body.
static inline scree_collidable_def scree_collidable_def_default(void);

// Creates count collidables and writes their handles to collidables (may be null). The masses of their bodies are
// computed again. On failure no collidable is created. A world holds at most 16,777,216 collidables.
SCREE_API scree_status scree_collidables_create(scree_world* world, const scree_collidable_def* defs, int count,
                                                scree_collidable* collidables);
// Creates one collidable and writes its handle to *collidable (may be null).
SCREE_API scree_status scree_collidable_create(scree_world* world, const scree_collidable_def* def,
                                               scree_collidable* collidable);

// Creates count collidables, each of the shape and surface shapes[k], which it owns as the collidables of
// scree_bodies_create_with_shapes do. defs[k].attribute must be null. On failure nothing is created.
SCREE_API scree_status scree_collidables_create_with_shapes(scree_world* world, const scree_collidable_def* defs,
                                                            const scree_attribute_def* shapes, int count,
                                                            scree_collidable* collidables);
// Creates one collidable with a shape, as above, and writes its handle to *collidable (may be null).
SCREE_API scree_status scree_collidable_create_with_shape(scree_world* world, const scree_collidable_def* def,
                                                          const scree_attribute_def* shape,
                                                          scree_collidable* collidable);

// Destroys collidables with their contacts; the masses of their bodies are computed again. On failure, for instance
// because a collidable is twice in the batch, no collidable is destroyed.
SCREE_API scree_status scree_collidables_destroy(scree_world* world, const scree_collidable* collidables, int count);
// Destroys one collidable, as above.
SCREE_API scree_status scree_collidable_destroy(scree_world* world, scree_collidable collidable);

// Returns true if the handle refers to an existing collidable.
SCREE_API bool scree_collidable_is_valid(const scree_world* world, scree_collidable collidable);

// Writes the handles of up to capacity collidables of a body, in the order in which they were added, and sets count to
// their number. For a null body the function lists the collidables without a body, in ascending index order.
SCREE_API scree_status scree_body_get_collidables(const scree_world* world, scree_body body,
                                                  scree_collidable* collidables, int capacity, int* count);

// Settings of one collidable, with the ranges of scree_collidable_def. Changes are uploaded with the next batch.

// Returns the body of a collidable, or a null handle.
SCREE_API scree_status scree_collidable_get_body(const scree_world* world, scree_collidable collidable,
                                                 scree_body* body);
// Returns the attribute of a collidable. The handle of an attribute that the collidable owns may be given to others; they
// own it too.
SCREE_API scree_status scree_collidable_get_attribute(const scree_world* world, scree_collidable collidable,
                                                      scree_attribute* attribute);
// Replaces the attribute. If the new shape is equal to the old one, contacts keep their impulses and use the surface of
// the new attribute from the next step on. Otherwise contacts end and begin again. The mass of a dynamic body is
// computed again from its collidables, unless shape and density are equal. Setting the current attribute changes
// nothing.
SCREE_API scree_status scree_collidable_set_attribute(scree_world* world, scree_collidable collidable,
                                                      scree_attribute attribute);
// Replaces the surface of one collidable; its shape, density, one_way and material stay. The collidable owns the attribute
// with the new surface afterwards, and others that used the old one keep that. Contacts keep their impulses, and use the
// new surface from the next step on. Setting the current surface changes nothing, and wakes nothing.
SCREE_API scree_status scree_collidable_set_surface(scree_world* world, scree_collidable collidable,
                                                    const scree_surface* surface);
// Returns the surface of a collidable.
static inline scree_status scree_collidable_get_surface(const scree_world* world, scree_collidable collidable,
                                                        scree_surface* surface);
// Returns the pose in the body's frame, or in the world for a collidable without a body.
SCREE_API scree_status scree_collidable_get_local_pose(const scree_world* world, scree_collidable collidable,
                                                       scree_pose* pose);
// Returns the filter of a collidable.
SCREE_API scree_status scree_collidable_get_filter(const scree_world* world, scree_collidable collidable,
                                                   scree_filter* filter);
// Replaces the filter. The contacts of the collidable end and begin again.
SCREE_API scree_status scree_collidable_set_filter(scree_world* world, scree_collidable collidable,
                                                   scree_filter filter);
// Returns the user data of a collidable.
SCREE_API scree_status scree_collidable_get_user(const scree_world* world, scree_collidable collidable, uint64_t* user);
// Sets the user data of a collidable.
SCREE_API scree_status scree_collidable_set_user(scree_world* world, scree_collidable collidable, uint64_t user);

// Returns the kinds of events that are listed for a collidable: bits of SCREE_REPORT_*.
SCREE_API scree_status scree_collidable_get_reports(const scree_world* world, scree_collidable collidable,
                                                    uint32_t* reports);
// Sets the kinds of events that are listed for a collidable (bits of SCREE_REPORT_*), from the next step on. The end of
// a touch that began with the old bits is still listed.
SCREE_API scree_status scree_collidable_set_reports(scree_world* world, scree_collidable collidable, uint32_t reports);
// Sets the kinds of events of a batch of collidables, as above. On failure no collidable changes.
SCREE_API scree_status scree_collidables_set_reports(scree_world* world, const scree_collidable* collidables,
                                                     const uint32_t* reports, int count);

// Returns the kinds of collidables that a sensor detects: bits of SCREE_SENSOR_*; 0: not a sensor.
SCREE_API scree_status scree_collidable_get_sensor(const scree_world* world, scree_collidable collidable,
                                                   uint32_t* sensor);
// Sets the kinds of collidables that a sensor detects (bits of SCREE_SENSOR_*), from the next step on. A collidable
// that becomes a sensor ends its touches. With 0 the collidable is no longer a sensor and has no visits.
SCREE_API scree_status scree_collidable_set_sensor(scree_world* world, scree_collidable collidable, uint32_t sensor);

// Teleports collidables without a body: sets their poses in the world, m. Fails with SCREE_ERROR_INVALID if any of the
// collidables belongs to a body.
SCREE_API scree_status scree_collidables_set_poses(scree_world* world, const scree_collidable* collidables,
                                                   const scree_pose* poses, int count);

// ---------------------------------------------------------------------------------------------------------------
// Paths
//
// A path is a smooth curve through points. Joints of type SCREE_JOINT_PATH hold bodies on a path: beads on a wire,
// wagons on a rail. The points of a path are in frame A of the joints that use the path. So a path can lie in the
// world, or on a body that moves, and one path can lie in several places. Positions on a path are arc lengths from its
// first point, in metres.
//
// The curve is the cubic spline through the points, whose parameter is the sum of the distances between successive
// points. Its curvature is continuous. More points make the curve more exact: with 12 points on a full circle the error
// is at most 1e-3 of the radius, with 24 points 1e-4.

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
	const scree_vec* points; // m, within SCREE_MAX_COORDINATE; neighbors at least 1e-4 m apart
	int count;               // 2 to 65,536; at least 3 for a closed path
	bool closed;             // true: the path continues from the last point to the first; default false
	uint64_t user;           // user data, not simulated; default 0
} scree_path_def;

// Returns a definition of an open path without points.
static inline scree_path_def scree_path_def_default(void);

// Creates a path and writes its handle to *path (may be null). The points are copied.
SCREE_API scree_status scree_path_create(scree_world* world, const scree_path_def* def, scree_path* path);

// Destroys a path. Fails with SCREE_ERROR_INVALID while a joint uses it.
SCREE_API scree_status scree_path_destroy(scree_world* world, scree_path path);

// Returns true if the handle refers to an existing path.
SCREE_API bool scree_path_is_valid(const scree_world* world, scree_path path);

// Writes the handles of up to capacity paths in ascending index order, and sets count to their number.
SCREE_API scree_status scree_world_get_paths(const scree_world* world, scree_path* paths, int capacity, int* count);

// Returns the arc length of a path, m; for a closed path, the length of one lap.
SCREE_API scree_status scree_path_get_length(const scree_world* world, scree_path path, float* length);

// Returns the point at an arc length (m, any finite value), and the direction of the path there as a rotation. On a
// closed path an arc length beyond the last point continues in the next lap; on an open path an arc length beyond an
// end gives that end.
SCREE_API scree_status scree_path_get_pose(const scree_world* world, scree_path path, float along, scree_pose* pose);

// Returns the arc length (m) at which the path is nearest to a point (m) of frame A.
SCREE_API scree_status scree_path_get_nearest(const scree_world* world, scree_path path, scree_vec point, float* along);

// Writes up to capacity points with which a path was created (m), and sets count to their number.
SCREE_API scree_status scree_path_get_points(const scree_world* world, scree_path path, scree_vec* points, int capacity,
                                             int* count);

// Returns true if the path exists and is closed.
SCREE_API bool scree_path_is_closed(const scree_world* world, scree_path path);
// Returns the user data of a path.
SCREE_API scree_status scree_path_get_user(const scree_world* world, scree_path path, uint64_t* user);
// Sets the user data of a path.
SCREE_API scree_status scree_path_set_user(scree_world* world, scree_path path, uint64_t user);

// ---------------------------------------------------------------------------------------------------------------
// Joints
//
// A joint holds two frames together: frame A in body A, frame B in body B. It measures three coordinates of frame B in
// frame A: `along` is the translation along the x axis of frame A, `across` the translation along its y axis, `angle`
// the rotation. Each coordinate can be locked, and can have limits, a spring and a motor. A type of joint presets these
// values (scree_joint_def_make), and each of them can be changed.
//
// A joint of type DISTANCE measures along the line from anchor A to anchor B instead: `along` is the distance.
// Joints of types GEAR and PULLEY measure each body in the world and couple the two measures (scree_joint_side).
//
// A joint of type PATH holds anchor B on a path, which lies in frame A. `along` is an arc length of the path, with all
// full laps on a closed path. `across` is the distance from the path, positive to the left of the path's direction.
// `angle` is the rotation of frame B relative to the direction of the path. The ends of an open path act as limits.
//
// Either body can be null: its frame is then in the world. Joints with a static or kinematic body are usual. A joint
// between two bodies that cannot move, or with a disabled body, has no effect.
//
// Method: Erin Catto, Soft Constraints, GDC 2011; Solver2D, 2024. docs/design/joints.md has the formulas,
// docs/manual/joints.md the equivalents of the joint types of other engines.
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

typedef enum scree_joint_type // comments: the locked coordinates, then other values that scree_joint_def_make sets
{
	SCREE_JOINT_FREE,      // no coordinate: for joints whose values the program sets
	SCREE_JOINT_DISTANCE,  // along, at along.target (1 m); unlock it for a spring, or for a rope with limits
	SCREE_JOINT_REVOLUTE,  // along and across: a hinge
	SCREE_JOINT_PRISMATIC, // across and angle: a slider along the x axis of frame A
	SCREE_JOINT_SLOT,      // across: a pin in a slot along the x axis of frame A
	SCREE_JOINT_WELD,      // all coordinates: the bodies move as one; lock_hertz makes the joint soft
	SCREE_JOINT_WHEEL,     // across; a spring along the x axis of frame A, 1 Hz, damping ratio 0.7
	SCREE_JOINT_MOTOR,  // no coordinate; motors on all three, speed 0 and maximum 0, to be set for friction or a drive
	SCREE_JOINT_TARGET, // no coordinate; springs along and across, 5 Hz, damping ratio 1: pull a body to frame A
	SCREE_JOINT_FILTER, // no coordinate: its only effect is that the two bodies do not touch
	SCREE_JOINT_GEAR,   // along: couples two angles (scree_joint_side)
	SCREE_JOINT_PULLEY, // along: couples two distances; the two bodies may collide
	SCREE_JOINT_PATH,   // across: a bead on a wire; also lock the angle for a wagon on a rail
} scree_joint_type;

// Returns the name of a type ("free", "distance", ...), a constant string; "unknown" for any other number.
SCREE_API const char* scree_joint_type_name(scree_joint_type type);

typedef enum scree_coordinate // coordinates of frame B in frame A
{
	SCREE_ALONG,
	SCREE_ACROSS,
	SCREE_ANGLE,
} scree_coordinate;

// One coordinate of a joint. Units are m and N, or rad and N m for the angle; speeds are per second. Soft locks and
// springs oscillate with the given frequency and damping ratio, up to a twelfth of the substep rate. Above this rate,
// or if one body has many soft locks and springs, they are damped more, so that they add no energy.
typedef struct scree_joint_coordinate
{
	float target; // the value at which a lock holds the coordinate, and to which a spring pulls it,
	              // within SCREE_MAX_COORDINATE; default 0
	bool locked;
	bool limited; // limits the coordinate to the range from lower to upper; the angle counts all turns
	bool spring;
	bool motor;
	float lock_hertz;           // stiffness of a soft lock, Hz, 0 to 1e6; 0 (default): the stiffness of the joint
	float lock_damping_ratio;   // damping ratio of a soft lock, 0 to 1e6, default 0
	float lower, upper;         // lower <= upper, within SCREE_MAX_COORDINATE; default 0
	float spring_hertz;         // Hz, 0 to 1e6; 0 (default): no spring, with any damping ratio
	float spring_damping_ratio; // 0 to 1e6, default 0
	float spring_max;           // largest force or torque of the spring, >= 0, default FLT_MAX
	// Largest force or torque with which the spring increases (push) and decreases (pull) the coordinate, >= 0, default
	// FLT_MAX. The smaller of this value and spring_max applies. With a push of 0 a spring of type DISTANCE is a rubber
	// band.
	float spring_push;
	float spring_pull;
	float motor_speed; // m/s or rad/s, within SCREE_MAX_COORDINATE; default 0
	float motor_max;   // largest force or torque of the motor, >= 0, default 0: off; at speed 0 it is friction
} scree_joint_coordinate;

typedef enum scree_measure // measure of a frame relative to a base, which is a frame of the world
{
	SCREE_MEASURE_ANGLE,       // rad, over all turns
	SCREE_MEASURE_TRANSLATION, // m: translation of the anchor along the x axis of the base
	SCREE_MEASURE_DISTANCE,    // m: distance of the anchor from the position of the base
} scree_measure;

// One side of a coupling. In joints of types GEAR and PULLEY, the coordinate `along` is the measure of frame B in its
// base, plus `ratio` times the measure of frame A in its base. This coordinate can have a lock, limits, a spring and a
// motor like any other. Its unit of force is N m if the measure of frame B is an angle. Bases do not move: couple two
// wheels of one vehicle through their angles only if the vehicle does not rotate.
typedef struct scree_joint_side
{
	scree_measure measure;
	scree_pose base;     // pose in the world; default: the origin of the world
	float initial_angle; // rad, default 0: the angle begins in the turn that is nearest to this value. Set by
	                     // scree_joint_def_couple
} scree_joint_side;

typedef struct scree_joint_def
{
	uint32_t size; // set by scree_joint_def_make
	scree_joint_type type;
	scree_body body_a, body_b;   // null: the world; the two must differ
	scree_pose frame_a, frame_b; // poses in the bodies' frames; default: the bodies' origins
	// The coordinates, by scree_coordinate. Limits, spring and motor have no effect while the coordinate is locked. A
	// definition is refused if a locked coordinate has a motor with a speed or a maximum. scree_joint_set_coordinate
	// may lock a coordinate that has such a motor.
	scree_joint_coordinate coordinates[3];
	// Stiffness of locks and limits, Hz, 0 to 1e6, default 60; 0: rigid, and errors are not corrected. The effective
	// frequency of locks, limits and springs is at most a quarter of the substep rate; joints in a row are stiffer
	// (docs/design/joints.md).
	float hertz;
	float damping_ratio;    // damping ratio of locks and limits, 0 to 1e6, default 2
	bool collide_connected; // true: the two bodies may touch each other; default false
	bool can_break;         // true: the joint breaks when a threshold is exceeded; default false
	bool disabled;          // true: the joint starts disabled (scree_joint_set_enabled); default false
	// If true, spring_max and motor_max of `along` and `across` are the half axes of an ellipse that bounds the force:
	// equal half axes give the same bound in all directions. Otherwise each value bounds only its own coordinate.
	// Default true for MOTOR and TARGET.
	bool elliptic;
	float force_threshold;     // N, >= 0, default FLT_MAX; scree_world_get_joint_events lists joints that exceed it
	float torque_threshold;    // N m, >= 0, default FLT_MAX; the same for the torque
	uint64_t user;             // user data, not simulated; default 0
	float ratio;               // GEAR, PULLEY: factor of the measure of frame A, -1e6 to 1e6, default 1
	scree_joint_side sides[2]; // GEAR, PULLEY: sides of A and B; default: angles of a GEAR, distances of a PULLEY
	scree_path path;           // PATH: the path on which anchor B is held
	// PATH: the arc length, laps included, at which the search for the point nearest to anchor B begins; m, within
	// SCREE_MAX_COORDINATE, default 0. Another part of the path is used only if its distance from anchor B is less than
	// half the distance of that point.
	float initial_along;
} scree_joint_def;

// Returns a definition with the defaults of a type and null bodies; the caller sets bodies and frames. With an unknown
// type, scree_joint_create refuses the definition.
static inline scree_joint_def scree_joint_def_make(scree_joint_type type);

// Sets frame_a and frame_b of a definition so that both lie at a pose in the world (m), for the current poses of the
// bodies, which the definition must already name. Locks and springs whose target is 0 then hold the bodies at their
// current poses. For type PATH the function sets only frame_b, because frame_a is the place of the path.
SCREE_API scree_status scree_joint_def_place(scree_world* world, scree_joint_def* def, scree_pose pose);

// Sets the target of the coordinate `along` of a GEAR or PULLEY to the coordinate's current value, so that two wheels
// keep their current angles and a rope its current length. The definition must already have bodies, frames, sides and
// ratio. Also sets sides[].initial_angle to the current angles. Fails with SCREE_ERROR_INVALID for other types.
SCREE_API scree_status scree_joint_def_couple(scree_world* world, scree_joint_def* def);

// Sets frame_b of a PATH joint so that it lies on the path at an arc length (m, within SCREE_MAX_COORDINATE), in the
// direction of the path, for the current poses of the bodies. The definition must already have bodies, frame_a and
// path. Also sets initial_along to that arc length. Fails with SCREE_ERROR_INVALID for other types.
SCREE_API scree_status scree_joint_def_mount(scree_world* world, scree_joint_def* def, float along);

// Creates count joints from count definitions and writes their handles to joints (may be null). On failure no joint is
// created. A world holds at most 16,777,216 joints.
SCREE_API scree_status scree_joints_create(scree_world* world, const scree_joint_def* defs, int count,
                                           scree_joint* joints);
// Creates one joint and writes its handle to *joint (may be null).
SCREE_API scree_status scree_joint_create(scree_world* world, const scree_joint_def* def, scree_joint* joint);

// Destroys joints. Destroying a body destroys its joints. On failure, for instance because a joint is twice in the
// batch, no joint is destroyed.
SCREE_API scree_status scree_joints_destroy(scree_world* world, const scree_joint* joints, int count);
// Destroys one joint.
SCREE_API scree_status scree_joint_destroy(scree_world* world, scree_joint joint);

// Returns true if the handle refers to an existing joint. A broken joint exists until it is destroyed.
SCREE_API bool scree_joint_is_valid(const scree_world* world, scree_joint joint);

// Writes the handles of up to capacity joints in ascending index order, and sets count to the number of joints.
SCREE_API scree_status scree_world_get_joints(const scree_world* world, scree_joint* joints, int capacity, int* count);
// Writes the handles of up to capacity joints of one body in ascending index order, and sets count to their number.
SCREE_API scree_status scree_body_get_joints(const scree_world* world, scree_body body, scree_joint* joints,
                                             int capacity, int* count);

// Returns the current definition of a joint: the values with which it was created, with all later changes.
static inline scree_status scree_joint_get_def(const scree_world* world, scree_joint joint, scree_joint_def* def);

// Changes of joints. Each function takes count joints and count values, with the units and ranges of scree_joint_def;
// on failure nothing has changed. Impulses stay, so a motor can get another speed in every step. A broken joint can be
// changed, and stays broken. If an angle without limit, spring and lock gets one of them, it starts in the turn that is
// nearest to the limit or target.

// Replaces one coordinate of each joint.
SCREE_API scree_status scree_joints_set_coordinates(scree_world* world, const scree_joint* joints,
                                                    scree_coordinate which, const scree_joint_coordinate* values,
                                                    int count);
// Sets the targets of locks and springs, m or rad.
SCREE_API scree_status scree_joints_set_targets(scree_world* world, const scree_joint* joints, scree_coordinate which,
                                                const float* targets, int count);
// Sets the speeds of motors, m/s or rad/s.
SCREE_API scree_status scree_joints_set_motor_speeds(scree_world* world, const scree_joint* joints,
                                                     scree_coordinate which, const float* speeds, int count);
// Sets both frames of each joint, in the frames of its bodies, m.
SCREE_API scree_status scree_joints_set_frames(scree_world* world, const scree_joint* joints,
                                               const scree_pose* frames_a, const scree_pose* frames_b, int count);

// The functions of one joint below have the units, ranges and effects of the batch functions with the same names.

// Replaces one coordinate.
SCREE_API scree_status scree_joint_set_coordinate(scree_world* world, scree_joint joint, scree_coordinate which,
                                                  const scree_joint_coordinate* value);
// Returns one coordinate as it was set.
SCREE_API scree_status scree_joint_get_coordinate(const scree_world* world, scree_joint joint, scree_coordinate which,
                                                  scree_joint_coordinate* value);
// Sets the target of the lock and the spring of a coordinate, m or rad.
SCREE_API scree_status scree_joint_set_target(scree_world* world, scree_joint joint, scree_coordinate which,
                                              float target);
// Sets the speed of the motor of a coordinate, m/s or rad/s.
SCREE_API scree_status scree_joint_set_motor_speed(scree_world* world, scree_joint joint, scree_coordinate which,
                                                   float speed);
// Sets both frames, in the frames of the bodies, m.
SCREE_API scree_status scree_joint_set_frames(scree_world* world, scree_joint joint, scree_pose frame_a,
                                              scree_pose frame_b);

// Enables or disables joints. A disabled joint has no effect, and does not keep its bodies from touching. It can still
// be read and changed. When a joint is enabled, it starts without impulses and keeps the counted turns of its angles. A
// broken joint stays broken. Enabling an enabled joint changes nothing, nor does disabling a disabled one. On failure
// no joint of the batch changes.
SCREE_API scree_status scree_joints_set_enabled(scree_world* world, const scree_joint* joints, const bool* enabled,
                                                int count);
// Enables or disables one joint, as above.
SCREE_API scree_status scree_joint_set_enabled(scree_world* world, scree_joint joint, bool enabled);

// Returns true if the joint exists and is enabled.
SCREE_API bool scree_joint_is_enabled(const scree_world* world, scree_joint joint);

// Settings of one joint, with the units and ranges of scree_joint_def.

// Sets the stiffness (Hz) and the damping ratio of locks and limits.
SCREE_API scree_status scree_joint_set_stiffness(scree_world* world, scree_joint joint, float hertz,
                                                 float damping_ratio);
// Sets the thresholds in N and N m. If can_break is true, a joint breaks when it exceeds one of them.
SCREE_API scree_status scree_joint_set_thresholds(scree_world* world, scree_joint joint, float force, float torque,
                                                  bool can_break);
// Sets the ratio of a GEAR or PULLEY; fails with SCREE_ERROR_INVALID for other types. For angles the new ratio applies
// only to later turns, so that a gear does not jump. For translations and distances it applies at once.
SCREE_API scree_status scree_joint_set_ratio(scree_world* world, scree_joint joint, float ratio);
// Sets the bases of a GEAR or PULLEY, as poses in the world; fails with SCREE_ERROR_INVALID for other types. From now
// on, the measures are relative to the new bases.
SCREE_API scree_status scree_joint_set_bases(scree_world* world, scree_joint joint, scree_pose base_a,
                                             scree_pose base_b);
// Selects whether the maxima of `along` and `across` are the half axes of an ellipse; see scree_joint_def.elliptic.
SCREE_API scree_status scree_joint_set_elliptic(scree_world* world, scree_joint joint, bool elliptic);
// Selects whether the two bodies may touch each other.
SCREE_API scree_status scree_joint_set_collide_connected(scree_world* world, scree_joint joint, bool collides);
// Sets the user data of a joint.
SCREE_API scree_status scree_joint_set_user(scree_world* world, scree_joint joint, uint64_t user);

typedef struct scree_joint_state
{
	// The coordinates, by scree_coordinate: m, m, rad; the angle counts all turns. For a GEAR or PULLEY: the coordinate
	// `along`, the measure of frame A, the measure of frame B.
	float values[3];
	float speeds[3]; // rates of change of `values`: m/s, m/s, rad/s
	scree_vec force; // N: force on body b in the last substep, in the world; its opposite acts on body a
	float torque;    // N m: torque on body b in the last substep; its opposite acts on body a
	bool broken;     // true if the joint broke: it has no effect
} scree_joint_state;

// Returns the states of count joints at the current poses. Forces are 0 before the first step.
static inline scree_status scree_joints_get_states(scree_world* world, const scree_joint* joints,
                                                   scree_joint_state* states, int count);
// Returns the state of one joint.
static inline scree_status scree_joint_get_state(scree_world* world, scree_joint joint, scree_joint_state* state);

typedef struct scree_joint_event // a joint whose force or torque exceeded its threshold in the last step
{
	scree_joint joint;
	float force, torque; // N, N m: maximum over the substeps
	bool broken;         // true if the joint broke in this step
	uint64_t user;       // user data of the joint
} scree_joint_event;

// Writes up to capacity events of the last step, in ascending index order of the joints, and sets count to their
// number. Joints that have been destroyed since the step are omitted.
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
	float normal_impulse;  // N s, impulse of the last substep
	float tangent_impulse; // N s, impulse of the last substep, along (normal.y, -normal.x)
	uint32_t feature;      // id of the corners or edges that touch; constant while they touch
} scree_contact_point;

typedef struct scree_contact_detail // data of a point in the last step with dt > 0
{
	float total_impulse;  // N s, normal impulse, summed over the substeps, restitution included
	float approach_speed; // m/s, approach speed of the surfaces at the start of the step; 0 if they moved apart
	int touched;          // 1 if the surfaces touched in some substep, even if they have parted since
} scree_contact_detail;

typedef struct scree_contact
{
	scree_collidable a, b;
	scree_vec normal; // unit vector from collidable a to collidable b
	// Color in the constraint graph of the solver, 0 to 62: constraints of one color share no body that can move. 63:
	// contact of a hub (a body with more than 32 contacts, or on belts that run against each other). -1: overlap.
	int color;
	int count; // number of points, 1 or 2
	scree_contact_point points[2];
	scree_body body_a, body_b;       // bodies of the two collidables; null for a collidable without a body
	uint64_t user_a, user_b;         // user data of the two collidables
	scree_contact_detail details[2]; // zero unless scree_world_def.contact_details is set, or in an event
	int destroyed_a, destroyed_b;    // 1 in an event whose collidable has been destroyed; its handles are stale
} scree_contact;

// Writes up to capacity touching contacts between bodies and sets count to their number. The order is that of the
// contact pool, the same on all devices.
static inline scree_status scree_world_get_contacts(scree_world* world, scree_contact* contacts, int capacity,
                                                    int* count);

// Writes up to capacity touching contacts of one body and sets count to their number, in the order of
// scree_world_get_contacts. The device gathers them, and no other contacts are transferred.
static inline scree_status scree_body_get_contacts(scree_world* world, scree_body body, scree_contact* contacts,
                                                   int capacity, int* count);

// Writes up to capacity pairs in which at least one collidable has no body, and sets count to their number, in the
// order of scree_world_get_contacts. Impulses are zero. A pair is listed if the shapes are within the speculative
// distance, 0.02 m; the shapes overlap if the separation is at most 0.
static inline scree_status scree_world_get_overlaps(scree_world* world, scree_contact* overlaps, int capacity,
                                                    int* count);

// ---------------------------------------------------------------------------------------------------------------
// Events
//
// Events of the last step, for collidables that report them (scree_collidable_def.reports). Events change no motion,
// and their order is the same on all devices. They cost nothing in a world without a collidable that reports.
// ---------------------------------------------------------------------------------------------------------------

typedef struct scree_hit // a contact whose surfaces met fast
{
	scree_collidable a, b;
	scree_body body_a, body_b;    // null for a collidable without a body
	uint64_t user_a, user_b;      // user data of the two collidables
	scree_vec point;              // m, in the world: the contact point with the larger impulse
	scree_vec normal;             // unit vector from collidable a to collidable b
	float approach_speed;         // m/s, at the start of the step: the larger value of the contact's points
	float impulse;                // N s: normal impulse of all points and substeps, restitution included
	int destroyed_a, destroyed_b; // as in scree_contact
} scree_hit;

typedef struct scree_visit // the overlap of a collidable, the visitor, with a sensor
{
	scree_collidable sensor, visitor;
	scree_body body_sensor, body_visitor; // null for a collidable without a body
	uint64_t user_sensor, user_visitor;   // user data of the sensor and of the visitor
	float time;                           // time at which the visit began or ended, as a fraction of the step, 0 to 1
	int destroyed_sensor, destroyed_visitor; // as in scree_contact
} scree_visit;

typedef struct scree_events
{
	uint32_t size, contact_size, hit_size; // set by scree_world_get_events

	// Touches in which at least one collidable has SCREE_REPORT_TOUCHES. A touch begins in the step in which the
	// surfaces push each other or overlap: contacts of surfaces that are only near do not count. A touch ends when the
	// surfaces are farther apart than 0.02 m. It also ends when a collidable is destroyed, disabled or gets another
	// shape, filter or type of body, or when a joint keeps the two apart. Each beginning has exactly one end. Within a
	// step, ends come before beginnings.
	//
	// Both lists have the same order on all devices. touches_began is in the order of scree_world_get_contacts, with
	// points, impulses and details. touches_ended is in ascending index order of collidable a, then of collidable b,
	// with handles, bodies and user data only.
	const scree_contact* touches_began;
	const scree_contact* touches_ended;

	// Contacts in which at least one collidable has SCREE_REPORT_HITS, and which exceeded scree_world_def.hit_speed and
	// hit_impulse, in the order of scree_world_get_contacts.
	const scree_hit* hits;

	int touches_began_count, touches_ended_count, hit_count;

	// Visits to sensors that began in the step, and visits that ended in it, in ascending index order of the sensor,
	// then of the visitor. Each beginning has exactly one end. The visit of a collidable that passes through a sensor
	// within the step is in both lists.
	uint32_t visit_size; // set by scree_world_get_events
	int visits_began_count, visits_ended_count;
	const scree_visit* visits_began;
	const scree_visit* visits_ended;

	// Joints whose force or torque exceeded a threshold, in ascending index order, as in scree_world_get_joint_events.
	uint32_t joint_size; // set by scree_world_get_events
	int joint_count;
	const scree_joint_event* joints;

	// Pending contacts, in the order of scree_world_get_contacts: at least one collidable has SCREE_REPORT_APPROVAL,
	// and the two touch, or will touch in this step, for the first time since they were apart.
	// scree_world_approve_contacts approves or refuses them. Their impulses are 0.
	int approval_count;
	const scree_contact* approvals;
} scree_events;

// Returns the events of the last step. The arrays belong to the world; they are valid until the next call of this
// function or of scree_world_step, or until the world is destroyed. Objects that have been destroyed since the step are
// listed with their old handles, and marked as destroyed.
static inline scree_status scree_world_get_events(scree_world* world, scree_events* events);

// Approves (true) or refuses (false) the contacts in scree_events.approvals of the last step. approved[k] belongs to
// approvals[k]. Fails with SCREE_ERROR_INVALID if count is not approval_count.
//
// An approved contact acts from the next step on, until its two collidables are farther apart than 0.02 m. A contact
// that is refused, or neither approved nor refused before the next step, has no effect: the two pass through each other
// until they are farther apart than 0.02 m. The next contact of the two is pending again.
//
// In the step in which a contact becomes pending, its bodies move at most to the poses at which they meet, and keep
// their velocities. A step of dt 0, or one that fails, refuses nothing: a contact that is still pending is listed again
// in the next step. A second call before the next step replaces the values of the first.
SCREE_API scree_status scree_world_approve_contacts(scree_world* world, const bool* approved, int count);

typedef struct scree_moved_body // a body that moved, fell asleep or woke
{
	scree_body body;
	uint64_t user; // user data
	scree_pose pose;
	scree_velocity velocity;
	bool asleep;
} scree_moved_body;

typedef struct scree_moved_bodies
{
	uint32_t size, body_size; // set by scree_world_get_moved_bodies
	int count;
	const scree_moved_body* bodies; // in ascending index order
} scree_moved_bodies;

// Returns the bodies that have moved since the last call, by motion or by the user, those that fell asleep or woke (see
// "Sleep"), and those that were created since. This is the data that a renderer or a network needs. The first call
// lists all bodies.
//
// A body has moved if any component of its pose (scree_body_get_pose) differs at all from that at the last call, even
// by a rounding error, which may occur in each step for a body at rest under a load. A body that is back at its earlier
// pose has not moved. A new center of mass, type or velocity does not count. A body that fell asleep and woke between
// two calls is not listed for that. After scree_world_load and scree_world_restore the poses also differ from those at the
// last call; the first call with a world of scree_world_create_from or scree_world_clone lists all bodies.
//
// The array belongs to the world; it is valid until the next call of this function, or until the world is destroyed.
// The device gathers the list, and only the list is transferred.
static inline scree_status scree_world_get_moved_bodies(scree_world* world, scree_moved_bodies* list);

// Writes up to capacity visits to a sensor that had not ended at the end of the last step, in ascending index order of
// the visitor, and sets count to their number. For a visit that began in that step, scree_visit.time is the time at
// which it began. Fails with SCREE_ERROR_INVALID for a collidable that is not a sensor.
static inline scree_status scree_collidable_get_visits(scree_world* world, scree_collidable sensor, scree_visit* visits,
                                                       int capacity, int* count);

// Sets scree_world_def.hit_speed (m/s, at least 0) and hit_impulse (N s, at least 0), from the next step on: slower and
// weaker contacts are not hits.
SCREE_API scree_status scree_world_set_hit_thresholds(scree_world* world, float speed, float impulse);

// ---------------------------------------------------------------------------------------------------------------
// Queries
//
// Queries find collidables in the current world, including changes since the last step: the first collidable that a ray
// or a moving shape meets, all collidables that it meets, all that overlap a shape, or the nearest one. Queries change
// no bit of the world. Results and their order are the same on all devices. docs/manual/queries.md has examples and times.
//
// One call takes one query or a million. On a GPU a call costs about 70 us even for one query, so put many into one
// call. The first call after a step or a change computes boxes of all collidables that can move: 25 ns each on one CPU
// thread.
//
// Queries use the exact shapes, without the distance of 0.02 m at which contacts begin. They ignore collidables of
// disabled bodies. Coordinates are at most SCREE_MAX_COORDINATE, translations at most twice that.
// ---------------------------------------------------------------------------------------------------------------

enum // bits of scree_query_def.kinds: the collidables that a query finds
{
	SCREE_QUERY_STATIC = 1,    // collidables of static bodies
	SCREE_QUERY_KINEMATIC = 2, // collidables of kinematic bodies
	SCREE_QUERY_DYNAMIC = 4,   // collidables of dynamic bodies
	SCREE_QUERY_FREE = 8,      // collidables without a body
	SCREE_QUERY_SENSORS = 16,  // sensors on bodies of any type, or without a body; the other bits exclude sensors
};

typedef struct scree_query_def // the collidables that the queries of a call find
{
	uint32_t size;     // set by scree_query_def_default
	uint32_t kinds;    // bits of SCREE_QUERY_*; default: STATIC, KINEMATIC and DYNAMIC
	uint64_t category; // bits; finds only collidables whose filter.mask has one of them; default all bits
	uint64_t mask;     // bits; finds only collidables whose filter.category has one of them; default all bits
	bool any;          // true: sets only scree_query_result.hit, which is faster; other members are 0; default false
	bool skip_inside;  // true: ignores collidables in which a ray or shape begins; default false
	bool one_way;      // true: ignores one-way platforms unless the query comes from the solid side; default false
} scree_query_def;

// Returns a definition with the default values.
static inline scree_query_def scree_query_def_default(void);

typedef struct scree_ray // 32 bytes
{
	scree_vec origin;      // m
	scree_vec translation; // m: from the origin to the end of the ray; 0 finds collidables at the origin
	float radius;          // m, 0 to SCREE_MAX_COORDINATE: radius of a circle that moves along the ray, 0 for a point
	uint32_t reserved;     // 0
	scree_body ignored;    // body whose collidables are not found; null or destroyed: no body is ignored
} scree_ray;

typedef struct scree_probe // 32 bytes: pose and motion of the shape in one query of a call
{
	scree_pose pose;       // initial pose of the shape; a rotation of {0, 0} is refused
	scree_vec translation; // m: motion of the shape without rotation; 0 for a shape at rest
	scree_body ignored;    // as in scree_ray
} scree_probe;

typedef struct scree_query_result // 32 bytes: the result of a query
{
	scree_collidable collidable; // null if nothing was found
	scree_vec point;             // m: point of the surface that was met or is nearest; if inside, start of the query
	scree_vec normal;            // unit vector from the collidable to the query; 0 if inside
	float fraction;              // fraction of the translation, 0 to 1; for scree_world_find_nearest the distance, m,
	                             // negative if the shapes overlap
	bool hit;                    // true if a collidable was found
	bool inside;                 // true if the ray or shape overlaps the collidable at the start of the query
	uint16_t reserved;           // 0
} scree_query_result;

typedef struct scree_query_results // all results of a call
{
	uint32_t size;                     // set by the function that fills it
	int count;                         // number of results
	const scree_query_result* results; // sorted by query, then by fraction, then by index of the collidable
	// first[k] is the index in results of the first result of query k; one more entry at the end has the value count.
	const int* first;
} scree_query_results;

// Prepares the world for queries: uploads pending changes, and computes with all threads of the world the boxes that the
// first query after a change would compute otherwise. No program needs the call; it only saves time. One thread at a time
// may make it, as with any function that is not listed here.
//
// Several threads may call these functions at the same time with the same world, while no other function uses it:
//   scree_world_cast_rays, scree_world_cast_ray, scree_world_cast_shapes, scree_world_cast_shape,
//   scree_world_list_rays, scree_world_list_shapes, scree_world_overlap_box, scree_world_overlap_shape,
//   scree_world_overlap_point, scree_world_find_nearest;
//   scree_bodies_get_poses, scree_bodies_get_velocities, scree_body_get_pose, scree_body_get_velocity,
//   scree_body_get_world_point, scree_body_get_local_point, scree_body_get_point_velocity;
//   and, after scree_world_prepare_queries, all functions with a const scree_world*.
// On the CPU they run in parallel; the first call after a change prepares the world, and the others wait for that. On another
// device they run one after another. Their results do not depend on the number of threads. In WebAssembly, only one thread
// may use a world.
SCREE_API scree_status scree_world_prepare_queries(scree_world* world);

// Finds the first collidable that each ray meets; of several at the same fraction, that with the lowest index.
// Writes one result per ray to found. def may be null for the default. Method: an 8-ary tree of boxes, searched in the
// order of the distance; rounded polygons are exact.
SCREE_API scree_status scree_world_cast_rays(scree_world* world, const scree_query_def* def, const scree_ray* rays,
                                             int count, scree_query_result* found);

// Casts one ray (m) with the default definition.
SCREE_API scree_status scree_world_cast_ray(scree_world* world, scree_vec origin, scree_vec translation,
                                            scree_query_result* found);

// Finds the first collidable that a shape meets when it moves from the pose of each probe by its translation. A null
// shape is a point. Shapes are as in scree_attribute_def. Writes one result per probe to found. def may be null for the
// default. Method: exact, without iterations: a ray against the Minkowski sum of the two shapes.
SCREE_API scree_status scree_world_cast_shapes(scree_world* world, const scree_query_def* def, const scree_shape* shape,
                                               const scree_probe* probes, int count, scree_query_result* found);

// Casts one shape with the default definition.
SCREE_API scree_status scree_world_cast_shape(scree_world* world, const scree_shape* shape, scree_pose pose,
                                              scree_vec translation, scree_query_result* found);

// Finds the nearest collidable within a distance (m, at least 0) of the shape at each probe, with its nearest point. A
// null shape is a point. If collidables overlap the shape, the result is the one that overlaps most. Translations must
// be 0, and def->any false. Writes one result per probe to found. def may be null for the default.
SCREE_API scree_status scree_world_find_nearest(scree_world* world, const scree_query_def* def,
                                                const scree_shape* shape, const scree_probe* probes, int count,
                                                float distance, scree_query_result* found);

// Shares device memory for queries whose rays and results stay on the device. The conditions, the ownership of the
// descriptor and the errors are those of scree_world_share_memory.
SCREE_API scree_status scree_world_share_queries(scree_world* world, int file_descriptor, size_t bytes);

// Casts count rays that lie in the memory of scree_world_share_queries, and writes count results there. rays_offset and
// found_offset are the offsets of the first ray and of the first result, in bytes, multiples of 4; they may be equal.
// The results are complete when the function returns. The rays are not checked: a ray that scree_world_cast_rays would
// refuse has an undefined result.
SCREE_API scree_status scree_world_cast_shared_rays(scree_world* world, const scree_query_def* def, size_t rays_offset,
                                                    int count, size_t found_offset);
// Casts a shape from count probes in the memory of scree_world_share_queries, as above; a null shape is a point.
SCREE_API scree_status scree_world_cast_shared_shapes(scree_world* world, const scree_query_def* def,
                                                      const scree_shape* shape, size_t probes_offset, int count,
                                                      size_t found_offset);

// Finds all collidables that each ray meets; a ray with translation 0 finds all that overlap its origin. The arrays of
// *list belong to the world; they are valid until the next call of this thread that fills a list, or until the world is
// destroyed. def may be null for the default; def->any must be false.
static inline scree_status scree_world_list_rays(scree_world* world, const scree_query_def* def, const scree_ray* rays,
                                                 int count, scree_query_results* list);
// Finds all collidables that a shape meets when it moves from the pose of each probe, as above; a null shape is a
// point.
static inline scree_status scree_world_list_shapes(scree_world* world, const scree_query_def* def,
                                                   const scree_shape* shape, const scree_probe* probes, int count,
                                                   scree_query_results* list);

// Finds all collidables that overlap a box (m), at least 2 mm wide and high, with the default definition. The arrays of
// *list belong to the world, as above.
static inline scree_status scree_world_overlap_box(scree_world* world, scree_box box, scree_query_results* list);
// Finds all collidables that overlap a shape at a pose, as above; a null shape is a point.
static inline scree_status scree_world_overlap_shape(scree_world* world, const scree_shape* shape, scree_pose pose,
                                                     scree_query_results* list);
// Finds all collidables that overlap a point (m), as above.
static inline scree_status scree_world_overlap_point(scree_world* world, scree_vec point, scree_query_results* list);

typedef struct scree_blast_def // an explosion; an implosion if the impulse is negative
{
	uint32_t size;      // set by scree_blast_def_default
	scree_vec position; // m
	float radius;       // m, 0 to SCREE_MAX_COORDINATE: nearer surfaces get the whole impulse; default 1
	float falloff;      // m, 0 to SCREE_MAX_COORDINATE: width of the ring beyond `radius` where the impulse falls to 0;
	                    // default 1
	float impulse;      // N s per m of a collidable's width as seen from the position; default 1
	uint64_t category;  // as in scree_query_def; default all bits
	uint64_t mask;      // as in scree_query_def; default all bits
} scree_blast_def;

// Returns a definition with the default values, at the origin.
static inline scree_blast_def scree_blast_def_default(void);

// Pushes the dynamic bodies around a position, and sets count (may be null) to the number of collidables that were
// pushed. Each collidable gets an impulse at its point that is nearest to the position, in the direction away from the
// position. If the position is inside a collidable, the impulse acts at its centroid. Sensors, disabled bodies and
// collidables beyond SCREE_MAX_COORDINATE get no impulse. The impulses are applied like those of
// scree_bodies_apply_impulses_at, in the order of the collidables. Walls shield no bodies; a program can instead find
// the visible bodies with scree_world_cast_rays and push only these. A list that a query returned stays valid.
SCREE_API scree_status scree_world_blast(scree_world* world, const scree_blast_def* def, int* count);

// Characters of one kind: upright capsules that are moved by queries. The sum of length, radius, step_height,
// snap_distance and 3 times skin is at most SCREE_MAX_COORDINATE.
typedef struct scree_mover_def
{
	uint32_t size;       // set by scree_mover_def_default
	uint32_t kinds;      // bits of SCREE_QUERY_*: collidables that stop a mover; default STATIC, KINEMATIC and DYNAMIC
	float length;        // m, 0 or 0.002 to SCREE_MAX_COORDINATE: distance between the centers of the capsule's ends, 0
	                     // for a circle; default 0.6
	float radius;        // m, 0.001 to SCREE_MAX_COORDINATE; default 0.3
	scree_vec up;        // unit vector; default (0, 1)
	float max_slope;     // rad, 0 to pi / 2: the steepest ground on which it can stand; default 50 degrees
	float step_height;   // m, 0 to SCREE_MAX_COORDINATE: the highest stair that it walks up; default 0.3
	float snap_distance; // m, 0 to SCREE_MAX_COORDINATE: largest move down that keeps it on the ground; default 0.3
	float skin;          // m, 0.001 to SCREE_MAX_COORDINATE: the distance that it keeps from collidables; default 0.01
	uint64_t category;   // as in scree_query_def; default all bits
	uint64_t mask;       // as in scree_query_def; default all bits
} scree_mover_def;

// Returns a definition with the default values.
static inline scree_mover_def scree_mover_def_default(void);

// A character. At first, set `position` and `velocity`, and all other members to zero. Between calls change only
// `position`, `velocity` and `ignored`.
typedef struct scree_mover
{
	scree_vec position;        // m: center of the capsule
	scree_vec velocity;        // m/s, relative to the ground; before a call: desired; after it: changed by collisions
	scree_body ignored;        // body that does not stop the mover, such as a body that follows it; as in scree_ray
	scree_collidable ground;   // the collidable on which the mover stands, null in the air
	scree_vec normal;          // normal of the ground, 0 in the air
	scree_pose ground_pose;    // pose of the ground's body; the next call moves the mover with the body from this pose
	scree_vec ground_velocity; // m/s: velocity that the ground gave the mover; add it to `velocity` for a jump
	scree_collidable wall;     // the last wall, ceiling or steep slope that stopped the mover, or null
	scree_vec wall_normal;     // unit vector from the wall to the mover, or 0; for a crushed mover wall_normal is 0
	                           // and `wall` is the collidable that the mover overlaps
} scree_mover;

// Moves characters for a time dt (s, 0 to 1); call it after each step. Movers slide along walls, stand still on slopes,
// walk up steps, follow the ground down, and ride on ground that moves. Collidables that move into a mover push it out,
// and so do kinematic bodies of any speed. A mover that cannot be pushed out, for instance between a lift and a
// ceiling, is crushed: it stays at its place, at rest, until it overlaps nothing.
//
// Movers do not collide with each other, and push no body (scree_movers_move_bodies does). Add gravity to a velocity in
// the air. On ground, a velocity component opposite to `up` is set to 0, and a component along `up` is a jump. def may
// be null for the default, in metres whatever length_unit is. A call makes ten to twenty batches of queries, however many
// movers there are; the bits are the same on every device. On failure movers are unchanged. docs/manual/movers.md describes
// the parts of a call.
SCREE_API scree_status scree_movers_move(scree_world* world, const scree_mover_def* def, scree_mover* movers, int count,
                                         float dt);

// Moves characters as scree_movers_move does, each with a kinematic body that follows it, and lets them push dynamic
// bodies. Call it before the step: at the end of the step, the bodies are where their movers are. Movers on ground that
// moves are an exception: their bodies go on with the ground.
//
// bodies: one per mover, each once; null for a mover without a body. The caller creates and destroys them, usually each
// with a capsule as in the definition. Sensors report such a body, and dynamic bodies are stopped by it. The call sets
// its target (scree_bodies_set_targets). It moves upright and at most at the speed of the mover: if its way is longer,
// for instance up a step, it is first teleported. A disabled body is teleported only. A mover ignores its own body. If
// `ignored` is another body, def must exclude the mover's own by category and mask, else the call is refused. Bodies of
// other movers stop a mover as any kinematic body does, unless def excludes them.
//
// push_force: N, 0 to FLT_MAX: with at most this force, a mover pushes the dynamic bodies that it walks or jumps
// against. They get impulses at the points that it touches, so that these points are at most as fast as the mover; the
// mover goes on at their speed. Bodies under a mover feel no weight. On failure, movers and bodies are unchanged.
SCREE_API scree_status scree_movers_move_bodies(scree_world* world, const scree_mover_def* def, scree_mover* movers,
                                                const scree_body* bodies, int count, float push_force, float dt);

// ---------------------------------------------------------------------------------------------------------------
// Fields
//
// A field pushes the dynamic bodies in a region in each step: by an additional gravity, attraction, a vortex, drag,
// wind, or a fluid in which they float. Its region is a shape that lies in the world or on a body, or the whole plane.
// The forces of several fields add up. The force of a step is computed at the poses in the middle of the step and the
// velocities at its start; docs/manual/fields.md has the formulas. Fields cost nothing in a world without fields.
//
// Types UNIFORM, RADIAL, VORTEX and DRAG act on a body, at its center of mass, if the center is in the region. WIND
// acts on each collidable whose middle is in the region, BUOYANCY on the part of each collidable that is in the region.
// Fields do not act on sensors, on disabled bodies or on the body that carries the field. That body feels no reaction.
// Static and kinematic bodies do not move by forces.

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
	SCREE_FIELD_DRAG,     // drag of a medium on bodies: linear and quadratic, and on their rotation
	SCREE_FIELD_WIND,     // drag and lift of a medium on the edges that face it, by the square of the speed
	SCREE_FIELD_BUOYANCY, // a fluid in the region; without a shape the fluid is below the x axis of the field's frame
} scree_field_type;

typedef enum scree_field_falloff // factor of the strength of RADIAL and VORTEX at the distance r from the origin
{
	SCREE_FALLOFF_CONSTANT,       // 1
	SCREE_FALLOFF_LINEAR,         // 1 - r / radius; 0 beyond radius
	SCREE_FALLOFF_INVERSE,        // radius / r
	SCREE_FALLOFF_INVERSE_SQUARE, // (radius / r)^2
} scree_field_falloff;

// A field. Capital words name the types that use a member; for other types the member must be finite and in range, and
// has no effect. Magnitudes of accelerations, forces, strengths, drags and densities are at most 1e12, lengths and
// velocities at most SCREE_MAX_COORDINATE.
typedef struct scree_field_def
{
	uint32_t size; // set by scree_field_def_default
	scree_field_type type;
	scree_body body;   // body that carries the region; the field is destroyed with it; null (default): the world
	scree_pose pose;   // pose of the field's frame in the frame of the body, or in the world; default: the origin
	scree_shape shape; // region, in the field's frame; shape.count 0 (default): everywhere; BUOYANCY: a sharp polygon
	bool disabled;     // true: the field has no effect; default false
	// The field acts on a collidable if `category` has a common bit with the mask of the collidable's filter, and
	// `mask` has one with the category of that filter. Types that act on bodies act on bodies with such a collidable.
	// With all bits in both members (default) the field acts on all collidables, regardless of filters.
	uint64_t category, mask;
	scree_vec acceleration;      // UNIFORM: m/s^2, in the field's frame; default 0
	scree_vec force;             // UNIFORM: N, in the field's frame; default 0
	float strength;              // RADIAL, VORTEX: m/s^2; default 10
	scree_field_falloff falloff; // RADIAL, VORTEX: default inverse square
	float radius;                // RADIAL, VORTEX: radius of the falloff, m, >= 1e-3; default 1
	float softening;             // RADIAL, VORTEX: m, >= 0, default 0.1; r^2 is the squared distance plus softening^2
	scree_vec velocity;   // DRAG, WIND, BUOYANCY: velocity of the medium, m/s, in the field's frame, in addition to
	                      // that of the field's body; default 0
	float density;        // WIND, BUOYANCY: density of the medium, kg/m^2, >= 0; default 1
	float drag;           // WIND, BUOYANCY: drag coefficient, >= 0, default 1: force / (density / 2 * width * speed^2)
	float lift;           // WIND: coefficient of the force across the wind, >= 0; default 0
	float linear_drag;    // DRAG: force per speed, kg/s, >= 0; default 0. BUOYANCY: the same per m^2; default 2
	float quadratic_drag; // DRAG: force per square of the speed, kg/m, >= 0; default 0
	float spin_drag;      // DRAG: torque per angular velocity, N m s, >= 0; default 0
	float spin_drag_quadratic; // DRAG: torque per square of the angular velocity, N m s^2, >= 0; default 0
	uint64_t user;             // user data, not simulated; default 0
} scree_field_def;

// Returns a definition of a type with the default values.
static inline scree_field_def scree_field_def_default(scree_field_type type);

// Creates a field and writes its handle to *field (may be null).
SCREE_API scree_status scree_field_create(scree_world* world, const scree_field_def* def, scree_field* field);

// Destroys a field.
SCREE_API scree_status scree_field_destroy(scree_world* world, scree_field field);

// Returns true if the handle refers to an existing field.
SCREE_API bool scree_field_is_valid(const scree_world* world, scree_field field);

// Returns the current definition of a field.
static inline scree_status scree_field_get_def(const scree_world* world, scree_field field, scree_field_def* def);
// Replaces the definition of a field, from the next step on. The handle stays valid.
SCREE_API scree_status scree_field_set_def(scree_world* world, scree_field field, const scree_field_def* def);

// Sets the pose of the field's frame, as in scree_field_def, from the next step on.
SCREE_API scree_status scree_field_set_pose(scree_world* world, scree_field field, scree_pose pose);

// Enables or disables a field, from the next step on.
SCREE_API scree_status scree_field_set_enabled(scree_world* world, scree_field field, bool enabled);

// Writes the handles of up to capacity fields in ascending index order, and sets count to their number.
SCREE_API scree_status scree_world_get_fields(const scree_world* world, scree_field* fields, int capacity, int* count);

// ---------------------------------------------------------------------------------------------------------------
// Two shapes, without a world
//
// Distances, casts and times of impact of shapes at given poses, with the geometry of queries. Coordinates are at most
// SCREE_MAX_COORDINATE. Results are the same on every machine.

typedef struct scree_distance
{
	// m: the nearest points of the surfaces, in the world. If the shapes overlap, point_b - point_a is distance times
	// normal.
	scree_vec point_a, point_b;
	scree_vec normal; // unit vector from shape a to shape b
	float distance;   // m: distance of the surfaces; negative: minus the depth of the overlap
} scree_distance;

// Returns the distance of two shapes; a null shape is a point. Method: exact, as the distance of a point from the
// Minkowski sum of the two.
SCREE_API scree_status scree_shapes_get_distance(const scree_shape* a, scree_pose pose_a, const scree_shape* b,
                                                 scree_pose pose_b, scree_distance* distance);

// Finds the point at which a ray meets a shape; translation: from origin to the end, m. found->collidable is null.
SCREE_API scree_status scree_shape_cast_ray(const scree_shape* shape, scree_pose pose, scree_vec origin,
                                            scree_vec translation, scree_query_result* found);
// Finds the point at which shape b, moving by a translation (m) without rotation, meets shape a. A null shape is a
// point. found->collidable is null.
SCREE_API scree_status scree_shapes_cast(const scree_shape* a, scree_pose pose_a, const scree_shape* b,
                                         scree_pose pose_b, scree_vec translation, scree_query_result* found);

// Sets contains to true if a point (m, in the world) is in a shape, its surface included.
SCREE_API scree_status scree_shape_contains(const scree_shape* shape, scree_pose pose, scree_vec point, bool* contains);

// Finds the time of impact of two shapes that move from one pose to another at constant speed, with the shorter
// rotation about their origins. found->fraction is the fraction of the motion at which their distance is at most 0.25
// mm; found->hit is false if they do not meet. Method: conservative advancement (Brian Mirtich, Impulse-based Dynamic
// Simulation of Rigid Body Systems, 1996), at most 200 iterations; a motion that needs more counts as a hit at the
// fraction that was reached.
SCREE_API scree_status scree_shapes_get_impact(const scree_shape* a, scree_pose from_a, scree_pose to_a,
                                               const scree_shape* b, scree_pose from_b, scree_pose to_b,
                                               scree_query_result* found);

// ---------------------------------------------------------------------------------------------------------------
// Drawing
//
// One row per collidable, laid out for a vertex buffer: row k is the collidable whose handle has the index k + 1.
// scree_world_get_render_rows copies the rows to the host. If scree_world_get_sharing returns SCREE_SHARING_MEMORY or
// SCREE_SHARING_OPENGL, the rows can stay on the device: share a buffer from which OpenGL draws, and
// scree_world_write_render_rows writes into it. Copied and shared rows have the same bits. docs/manual/share.md has an
// example.

typedef struct scree_render_row // 32 bytes
{
	scree_pose pose;   // pose of the attribute's shape in the world
	scree_vec center;  // vector from pose.position to the body's center of mass, world axes, m
	int32_t attribute; // index of the attribute's handle; -1: no collidable, skip the row
	int32_t body;      // index of the body's handle, 1 or more; -1: no body
} scree_render_row;

// Writes up to capacity rows of the current state and sets count to the number of rows. That number is the highest
// index that the handle of a collidable has had so far. rows may be null if capacity is 0.
SCREE_API scree_status scree_world_get_render_rows(scree_world* world, scree_render_row* rows, int capacity,
                                                   int* count);

// Returns the fastest kind of sharing of render rows that this world supports: SCREE_SHARING_OPENGL if the driver
// accepted scree_world_def.opengl, otherwise SCREE_SHARING_MEMORY if the device supports it, otherwise
// SCREE_SHARING_COPIED.
SCREE_API scree_sharing scree_world_get_sharing(const scree_world* world);

// Shares memory that another API allocated on the same device (scree_device.uuid) and exported as an opaque file
// descriptor. Vulkan can export (VK_KHR_external_memory_fd), and OpenGL can import (GL_EXT_memory_object_fd). On
// success the world owns the descriptor. bytes is the usable size, at least one row. Fails with
// SCREE_ERROR_NOT_SUPPORTED if scree_world_get_sharing is not SCREE_SHARING_MEMORY, or if the driver rejects the
// memory. Sharing ends with the next call of this function, scree_world_unshare, a move to another device (which "auto"
// may do), or scree_world_destroy.
SCREE_API scree_status scree_world_share_memory(scree_world* world, int file_descriptor, size_t bytes);

// Shares a buffer object of the context scree_world_def.opengl. The context must be current on the calling thread here
// and in scree_world_write_render_rows. bytes is the size of the buffer's storage, at least one row. The buffer and its
// storage must outlive the sharing. Fails with SCREE_ERROR_NOT_SUPPORTED if scree_world_get_sharing is not
// SCREE_SHARING_OPENGL, or if the driver rejects the buffer.
SCREE_API scree_status scree_world_share_opengl(scree_world* world, uint32_t buffer, size_t bytes);

// Ends all sharing, also that of queries, and releases the imported memory or buffer. world may be null. Without
// sharing the call does nothing.
SCREE_API void scree_world_unshare(scree_world* world);

// Writes the rows of the current state into the shared memory and sets count to their number. The rows are complete
// when this function returns. The caller must ensure that OpenGL has finished reading the previous rows, for instance
// with a fence. If the rows do not fit, the function fails with SCREE_ERROR_INVALID but still sets count; share a
// larger buffer then. It also fails with SCREE_ERROR_INVALID if nothing is shared.
SCREE_API scree_status scree_world_write_render_rows(scree_world* world, int* count);

// Writes rows as scree_world_get_render_rows does, with bodies at the poses of scree_world_get_interpolated. alpha:
// fraction of the last step, 0 to 1; 1 gives the rows of the current state. Collidables without a body stand.
SCREE_API scree_status scree_world_get_interpolated_rows(scree_world* world, float alpha, scree_render_row* rows,
                                                         int capacity, int* count);
// Writes the same rows into the shared memory, and fails as scree_world_write_render_rows does.
SCREE_API scree_status scree_world_write_interpolated_rows(scree_world* world, float alpha, int* count);

// ---------------------------------------------------------------------------------------------------------------
// Clock
//
// Divides the time of frames into steps of one length. No world refers to a clock, and no recording contains one.
// docs/manual/time.md describes slow motion, pause and long frames.
//
//     scree_clock clock = scree_clock_default(1.0f / 60.0f);
//     // each frame; seconds: time since the last frame
//     for (int left = scree_clock_advance(&clock, seconds); left > 0; --left)
//         scree_world_step(world, clock.dt, 4);
//     scree_world_get_interpolated(world, clock.alpha, bodies, poses, capacity, &count);

typedef struct scree_clock
{
	float dt;           // s: length of a step, 1e-9 to 1, as that of scree_world_step
	float time_scale;   // simulated time per time of frames: 1 for real time, 0.25 for slow motion; 0 stops the time
	int32_t most_steps; // maximum number of steps of a frame, at least 1; the default is 8
	bool paused;        // true: frames count as 0 s
	float alpha;        // result: the part of a step that has passed since the last step, 0 to below 1
	double rest;        // s: result: simulated time since the last step, from 0 to below dt
	double dropped;     // s: result: simulated time of the last frame beyond most_steps, which is lost
} scree_clock;

// Returns a clock in real time, at the beginning of a step. dt: s.
static inline scree_clock scree_clock_default(float dt)
{
	scree_clock clock = {dt, 1.0f, 8, false, 0.0f, 0.0, 0.0};
	return clock;
}

// Advances a clock by the time of a frame, s, and returns the number of steps to take: 0 to most_steps. Sums are in
// double, so that clock and frames do not drift apart. Whole steps above most_steps are dropped, and the part of a step
// is kept. A time or scale that is negative or NaN counts as 0, an infinite one as a frame without end: most_steps
// steps, alpha 0. A null clock, or a dt out of range, gives no steps.
static inline int scree_clock_advance(scree_clock* clock, double seconds)
{
	if (!clock)
		return 0;
	clock->dropped = 0.0;
	if (!(clock->dt >= 1e-9f && clock->dt <= 1.0f))
		return 0;
	int most = clock->most_steps > 1 ? clock->most_steps : 1;
	double dt = (double)clock->dt;
	if (!(clock->rest > 0.0))
		clock->rest = 0.0;
	if (!clock->paused && seconds > 0.0 && clock->time_scale > 0.0f)
		clock->rest += seconds * (double)clock->time_scale;
	double steps = clock->rest / dt;
	if (!(steps < 9.0e15)) // the time has no part of a step left
	{
		clock->dropped = clock->rest - (double)most * dt;
		clock->rest = 0.0;
		clock->alpha = 0.0f;
		return most;
	}
	int64_t whole = (int64_t)steps;
	clock->rest -= (double)whole * dt;
	// the quotient is rounded, so the rest may be slightly below 0
	if (!(clock->rest > 0.0))
		clock->rest = 0.0;
	if (whole > most)
		clock->dropped = (double)(whole - most) * dt;
	clock->alpha = (float)(clock->rest / dt);
	if (!(clock->alpha < 1.0f))
		clock->alpha = 0.99999994f; // the largest float below 1
	return whole > most ? most : (int)whole;
}

// ---------------------------------------------------------------------------------------------------------------
// Many worlds at once (docs/manual/batch.md)
// ---------------------------------------------------------------------------------------------------------------
//
// A batch steps up to millions of small worlds at once. They are copies of templates, which are ordinary worlds. Each has
// the bits that it has alone: they do not depend on its number, on the other worlds, or on the device.

typedef struct scree_batch scree_batch;

typedef struct scree_batch_def
{
	uint32_t size; // set by scree_batch_def_default
	int worlds;    // number of worlds, 1 to 16,777,216; default 1
	// Array of template_count worlds, at least one. They are copied, so the program may change or destroy them. Each has at
	// most 4,096 bodies, collidables, contacts and joints, and 64 pending targets; there are no contacts that need approval,
	// and no visits to a collidable that was a sensor, but is none since the last step. Fields, tuning and sleep of a world
	// are those of its template.
	scree_world** templates;
	int template_count;
	const int* template_of; // for each world, the index of its template; null (default): world i has template i modulo
	                        // template_count
	// true: worlds may get other templates (scree_batch_set_templates), so there is memory for all templates in each part of
	// the batch, and bays of all worlds fit the largest one. Default false.
	bool other_templates;
	// Maximum number of contacts of a world, 0 to 4,096; 0 (default): 4,096, or fewer if there are more than 16,384 worlds. A
	// world that gets more is left as it was and paused (scree_batch_counters.crowded); alone, with this
	// scree_world_def.contact_limit, its step would be refused.
	int contact_limit;
	const char* device;      // "cpu" (default), "opencl" or "opencl:NAME", as in scree_world_def
	int threads;             // CPU worker threads, 0 to 64; 0 (default): one per core
	int lanes;               // as in scree_world_def
	bool allow_unequal_bits; // as in scree_world_def
	float device_timeout;    // as in scree_world_def
	bool timings;            // as in scree_world_def; scree_batch_get_timings
} scree_batch_def;

// Returns a definition with the default values.
static inline scree_batch_def scree_batch_def_default(void);

// Creates a batch, whose worlds are in the states of their templates. The caller owns *batch and destroys it with
// scree_batch_destroy. On failure *batch is null. Fails with SCREE_ERROR_INVALID if a template has something that worlds
// in a batch cannot have. Several threads may create batches of the same templates at once, but no other function may use
// these then.
SCREE_API scree_status scree_batch_create(const scree_batch_def* def, scree_batch** batch);

// Destroys a batch. batch may be null.
SCREE_API void scree_batch_destroy(scree_batch* batch);

// Applies the inputs of the steps, advances all worlds that are not paused by `steps` steps, at least 0, and writes the outputs.
// With 0 steps it does nothing. dt, substeps: as for scree_world_step. A world with more contacts than
// scree_batch_def.contact_limit is left as it was before the step, and paused; its inputs have acted, and bodies with a
// target stand. All others go on. Inputs out of range are refused, and nothing changes. Another failure breaks the batch: every later call returns the same status, and it can only
// be destroyed.
SCREE_API scree_status scree_batch_step(scree_batch* batch, float dt, int substeps, int steps);

// Puts worlds back to the states of their templates. Worlds that were paused then run. mask: one byte per world, other than 0
// for each world to reset; null: all worlds. Masses, surfaces, and what is enabled, become those of the template. Gravity that
// was set stays; bodies wake if it is not that of the template.
SCREE_API scree_status scree_batch_reset(scree_batch* batch, const uint8_t* mask);

// Gives worlds other templates from their next reset on: robots of other sizes, levels with other walls. Until then nothing
// changes. template_of: for each world the index of a template, which must have the tuning of its present one. Fails with
// SCREE_ERROR_INVALID if scree_batch_def.other_templates was false.
SCREE_API scree_status scree_batch_set_templates(scree_batch* batch, const int32_t* template_of);

// Pauses worlds: they are not stepped until a later call has byte 0 for them, or they are reset. They cost no time. mask: one
// byte per world, other than 0 for each world to pause; all other worlds run, also those that were paused because they had too
// many contacts; null: all worlds run.
SCREE_API scree_status scree_batch_pause(scree_batch* batch, const uint8_t* mask);

// Sets the gravity of each world from the next step on, m/s^2: as scree_world_set_gravity does for a world alone. It stays
// until it is set again, also when worlds are reset. gravity: array with one finite vector per world, which is copied; in the
// unit of length of the world's template; null: worlds have the gravity of their templates, as at first. The bodies of worlds
// whose gravity changes wake. On failure no gravity changes.
SCREE_API scree_status scree_batch_set_gravity(scree_batch* batch, const scree_vec* gravity);

typedef struct
    scree_batch_counters // counters of a world; all but crowded are those of scree_counters, for the world alone
{
	// Contacts that the world needed when it was paused because they were more than scree_batch_def.contact_limit; 0 if it
	// was not, or after it ran again or was reset.
	int32_t crowded;
	int32_t frozen_bodies, contacts, touching;
	float penetration, joint_gap; // m, or the unit of length of the template
	int32_t asleep_bodies;
} scree_batch_counters;

// Writes the counters of the last step of each world, paused ones too. counters: array with one entry per world. After a reset
// they are those of the template.
static inline scree_status scree_batch_get_counters(scree_batch* batch, scree_batch_counters* counters);

// Returns the times of the last step of the last call of scree_batch_step; zeros unless scree_batch_def.timings is set. `step` is
// the duration of that call. On a CPU the times of the stages are sums over the threads; `queries` is 0.
static inline scree_status scree_batch_get_timings(scree_batch* batch, scree_timings* timings);

// Writes the hash of each world: the one that scree_world_get_hash returns for the same world alone. hashes: array with
// one entry per world.
SCREE_API scree_status scree_batch_get_hashes(scree_batch* batch, uint64_t* hashes);

// Returns the size of the state of one world of the batch, bytes; 0 if batch is null. It can become larger in a step,
// or by scree_batch_load, because worlds get more contacts.
SCREE_API size_t scree_batch_get_state_bytes(const scree_batch* batch);

// Writes the states of `count` worlds. worlds: their indices; a world may occur more than once. State k begins at byte
// k * state_bytes of `states`; state_bytes is at least scree_batch_get_state_bytes. States contain no addresses: they
// may be moved, stored, and sent to other computers.
SCREE_API scree_status scree_batch_save(scree_batch* batch, const int32_t* worlds, int count, void* states,
                                        size_t state_bytes);

// Puts `count` different worlds into states, so that they have the hashes of the saved worlds. State k begins at byte
// k * state_bytes of `states`; if state_bytes is 0, all worlds get the first state. States may come from another batch,
// device or process with the same version of the library; the template of each world must have the structure and the
// settings of the one of the saved world, and may be in any state, with other masses of bodies whose mass was set in
// both, other surfaces, and other bodies and joints disabled. Targets of kinematic bodies that the saved world has not
// reached must be pending in the template too. Gravity is not part of a state: a world keeps its own. Fails with
// SCREE_ERROR_INVALID, and changes nothing, if a state is damaged or does not fit.
SCREE_API scree_status scree_batch_load(scree_batch* batch, const int32_t* worlds, int count, const void* states,
                                        size_t state_bytes);

// Creates an ordinary world with the state and the hash of a world of a batch. def: device and threads, as for
// scree_world_clone; null: a CPU with one thread. Handles of the template are valid in it. It has the gravity of the
// world. Events of the last step, and contact details, are not part of the state; visits to sensors are, so those that
// last do not begin again. The caller owns *made and destroys it with scree_world_destroy. On failure *made is null.
SCREE_API scree_status scree_batch_extract(scree_batch* batch, int world, const scree_world_def* def,
                                           scree_world** made);

// Puts a world of a batch into the state of an ordinary world, which stays as it is: one of scree_batch_extract, or a
// clone of the template. It may have been stepped, and have other poses, velocities, forces, motor speeds, joint targets,
// masses and surfaces, and other bodies and joints may be disabled. Fails with SCREE_ERROR_INVALID, and changes nothing, if
// shapes, densities, joints, rules or settings differ from those of the template of the world, or for the reasons of
// scree_batch_load.
SCREE_API scree_status scree_batch_insert(scree_batch* batch, int world, scree_world* from);

// Returns the number of worlds; 0 if batch is null.
SCREE_API int scree_batch_get_worlds(const scree_batch* batch);

// Channels set and read values of all worlds at once. A channel is one or more columns of an array of floats, which has a
// row for each world. It names an object of a template by its handle. A world whose template lacks the object ignores the
// inputs of the channel, and its outputs are 0.

typedef enum scree_channel_kind // comments: the columns, with the units and ranges of the functions of one world
{
	// Inputs.
	SCREE_INPUT_FORCE,           // body: force x, y, N, at the center of mass
	SCREE_INPUT_THRUST,          // body: force x, y, N, along the axes of the body, at `point`
	SCREE_INPUT_TORQUE,          // body: torque, N m
	SCREE_INPUT_IMPULSE,         // body: impulse x, y, N s, at the center of mass
	SCREE_INPUT_ANGULAR_IMPULSE, // body: angular impulse, N m s
	SCREE_INPUT_VELOCITY,        // body: linear x, y, m/s; angular, rad/s
	SCREE_INPUT_POSE,            // body: pose of its origin: x, y, m; cosine, sine
	// Kinematic body: pose at the end of the step (scree_bodies_set_targets). It acts in steps with dt above 0 while the body is
	// enabled; others do not keep it for later, and leave a target of the template as it is. Inputs of resets have none.
	SCREE_INPUT_TARGET,
	SCREE_INPUT_MOTOR_SPEED,  // joint: speed of the motor of coordinate `which`, m/s or rad/s
	SCREE_INPUT_MOTOR_MAX,    // joint: largest force or torque of this motor, N or N m, at least 0
	SCREE_INPUT_JOINT_TARGET, // joint: target of lock and spring of coordinate `which`, m or rad
	// Parameters of worlds. They stay until they are set again, and are set before the other inputs, in this order. A value
	// equal to the present one changes nothing.
	SCREE_INPUT_GRAVITY, // world: gravity x, y, m/s^2 (scree_batch_set_gravity)
	// Dynamic body: mass, inertia, center of mass x, y (scree_body_set_mass). Mass and inertia, also the one that shapes and joints
	// require, are at most 2^40, because heavier bodies change the rounding in all worlds of the batch.
	SCREE_INPUT_MASS,
	SCREE_INPUT_SURFACE,       // `collidable`: friction, restitution, rolling resistance, tangent speed (scree_surface)
	SCREE_INPUT_ENABLED,       // body: 1 to enable it, 0 to disable it (scree_body_set_enabled)
	SCREE_INPUT_JOINT_ENABLED, // joint: 1 to enable it, 0 to disable it (scree_joint_set_enabled)
	// Outputs.
	SCREE_OUTPUT_POSE,          // body: pose of its origin: x, y, m; cosine, sine
	SCREE_OUTPUT_VELOCITY,      // body: linear x, y, m/s; angular, rad/s
	SCREE_OUTPUT_RELATIVE_POSE, // body: the same pose in the frame of the body `other`
	SCREE_OUTPUT_REST, // dynamic body of a template that sleeps: time for which it has been at rest (slower than
	                   // scree_world_def.sleep_threshold), s; at least 0.5 while it sleeps
	// Touches of `collidable`, or if it is null of all collidables of `body`; with `other_collidable`, or with the body
	// `other`, or if both are null with anything: number of touching contacts; 1 if there are some and the last outputs
	// had none, else 0; sum of their normal impulses in the last substep, N s.
	SCREE_OUTPUT_TOUCH,
	SCREE_OUTPUT_JOINT_VALUE, // joint: coordinate `which`, m or rad (scree_joint_state)
	SCREE_OUTPUT_JOINT_SPEED, // joint: rate of change of coordinate `which`, m/s or rad/s
	SCREE_OUTPUT_JOINT_FORCE, // joint: force x, y, N, and torque, N m, on body b in the last substep
	// A fan of `rays` rays from `point` of the body, which they do not meet; a null body stands for the world. One column
	// for each ray: the fraction of its way at which it meets the first collidable, 1 if it meets none. `translation` is
	// the way of a single ray, and the middle of the fan, whose rays are distributed evenly over the angle `spread`.
	SCREE_OUTPUT_RAYS,
	SCREE_OUTPUT_SENSOR_COUNT, // sensor `collidable`: number of its visits at the end of the last step, as
	                           // scree_collidable_get_visits lists them
	// Values of the world: all handles of the channel are null.
	SCREE_OUTPUT_OVERLAP,    // deepest overlap at the start of the last step, m (scree_batch_counters.penetration)
	SCREE_OUTPUT_JOINT_GAP,  // widest gap of a joint in the last step, m (scree_batch_counters.joint_gap)
	SCREE_OUTPUT_NOT_FINITE, // 1 if a body was frozen in the last step, because its state was not finite, else 0
} scree_channel_kind;

typedef struct scree_channel
{
	uint32_t size; // set by scree_channel_make
	scree_channel_kind kind;
	scree_body body, other;
	scree_collidable collidable, other_collidable;
	scree_joint joint;
	scree_coordinate which;  // default SCREE_ALONG
	scree_vec point;         // m, in the frame of the body; default 0
	scree_vec translation;   // m, in the frame of the body; default 0
	int rays;                // 1 to 1024, default 1
	float spread;            // rad, 0 to 2 pi; default 0. At 2 pi, first and last ray differ
	uint64_t category, mask; // filter of rays, as in scree_query_def; default: all bits
} scree_channel;

// Returns a channel with default values and null handles.
static inline scree_channel scree_channel_make(scree_channel_kind kind);

typedef enum scree_channels // lists of channels of a batch
{
	SCREE_STEP_INPUTS, // scree_batch_step reads them. Before the first step of a call all are applied; before each further
	                   // one only forces and torques. Those of paused worlds have no effect, but must be in range too
	SCREE_RESET_INPUTS, // scree_batch_reset reads them, and applies them to the worlds that it resets
	SCREE_OUTPUTS,      // scree_batch_step and scree_batch_observe write them
} scree_channels;

// Replaces a list of channels. memory: array of floats with a row for each world and the columns of the channels in their
// order; the program owns it, and keeps it until it binds other memory, or destroys the batch. With null the batch makes the
// array (scree_batch_get_rows), in memory that a GPU transfers fastest. count 0: the list is empty. Touches of the outputs
// are counted from now on. On failure the list stays as it was. A list has at most 4,096 columns.
SCREE_API scree_status scree_batch_bind(scree_batch* batch, scree_channels list, const scree_channel* channels,
                                        int count, float* memory);

// Lets the rows of a bound list stay on the device, in memory that another API allocated there and exported as an opaque file
// descriptor, as for scree_world_share_memory: CUDA and Vulkan can. Steps then read the inputs there, and check them there; they
// write the outputs there, which are complete when the call returns. Nothing is transferred over the bus. The memory that was
// bound is released, or stays that of the program. On success the batch owns the descriptor. bytes: size of the memory, at least 4 times worlds times
// columns; row k begins at byte 4 times k times columns. Sharing ends when the list is bound again. Fails with
// SCREE_ERROR_NOT_SUPPORTED for SCREE_RESET_INPUTS, for poses, targets and parameters, for a unit of length, for templates with
// different tunings, and if the device does not share memory (SCREE_SHARING_MEMORY).
SCREE_API scree_status scree_batch_share_rows(scree_batch* batch, scree_channels list, int file_descriptor,
                                              size_t bytes);

// Returns the number of columns of a list; 0 if batch is null.
SCREE_API int scree_batch_get_columns(const scree_batch* batch, scree_channels list);

// Returns the array of a list: the memory that was bound, or that the batch made, which is valid until the list is bound
// again. Null if the list is empty or shared, or if batch is null.
SCREE_API float* scree_batch_get_rows(const scree_batch* batch, scree_channels list);

// Writes the outputs of the current state, for instance after a reset. Rows of paused worlds stay as they were.
SCREE_API scree_status scree_batch_observe(scree_batch* batch);

// ---------------------------------------------------------------------------------------------------------------
// Debug draw (docs/manual/debug_draw.md)
//
// One call hands everything in a part of the world to functions of the program: lines, filled polygons, circles and
// capsules, points and texts, with colors. It reads each array of the device once, whatever the number of shapes.
// examples/draw/ has adapters for raylib, SDL and Dear ImGui.

enum // bits of scree_draw_def.flags, in the order in which they are drawn
{
	SCREE_DRAW_FIELDS = 1,    // region, origin and direction of each field
	SCREE_DRAW_SHAPES = 2,    // solid collidables, in the color of their state
	SCREE_DRAW_SENSORS = 4,   // sensors, and collidables without a body
	SCREE_DRAW_BOXES = 8,     // enlarged boxes of broad phase, of the last step
	SCREE_DRAW_JOINTS = 16,   // bodies to anchors, anchor to anchor, axes, limits of angles, paths
	SCREE_DRAW_CONTACTS = 32, // points and normals of touching contacts
	SCREE_DRAW_IMPULSES = 64, // impulses of contacts in the last substep: a line each along normal and tangent
	SCREE_DRAW_CENTERS = 128, // centers of mass, with the x axis of the body
	SCREE_DRAW_SPEEDS = 256,  // velocities of centers of mass
	SCREE_DRAW_LABELS = 512,  // texts beside that which is drawn: index of a body, type of a joint, N s, m/s
};

// Colors as 0xRRGGBBAA, alpha 255 is opaque. Fills have an alpha below 255; their outlines have the same color with alpha
// 255. A collidable has the first color that applies: DISABLED, SENSOR, FROZEN, STATIC, KINEMATIC, ASLEEP, DYNAMIC.
#define SCREE_COLOR_DISABLED    0x60606060u // disabled body; disabled joint, with alpha 255
#define SCREE_COLOR_SENSOR      0xf0e06a40u // sensor, or collidable without a body
#define SCREE_COLOR_FROZEN      0xff203080u // first body that was frozen in the last step (scree_counters.frozen_bodies)
#define SCREE_COLOR_STATIC      0x7fae7c80u
#define SCREE_COLOR_KINEMATIC   0x7090f080u
#define SCREE_COLOR_ASLEEP      0x8c8ca080u
#define SCREE_COLOR_DYNAMIC     0xe8b06080u
#define SCREE_COLOR_FIELD       0x40b0a030u
#define SCREE_COLOR_BOX         0xb060d0ffu
#define SCREE_COLOR_JOINT       0x50d0d0ffu
#define SCREE_COLOR_BROKEN      0xff7040ffu // broken joint
#define SCREE_COLOR_TOUCHING    0xff5050ffu // contact point without a gap
#define SCREE_COLOR_SPECULATIVE 0x70b0ffffu // contact point with a gap
#define SCREE_COLOR_IMPULSE     0xffe050ffu // impulse along the normal
#define SCREE_COLOR_FRICTION    0xa0e050ffu // impulse along the surface
#define SCREE_COLOR_CENTER      0xffffffffu
#define SCREE_COLOR_SPEED       0x80ff80ffu

// The functions that draw. Each may be null, and then nothing of its kind is drawn. They are called on the thread of the
// caller, with points in the world, m. Arrays and texts are valid during the call. A function must return, and must not
// use the world: calls that change or read its state fail with SCREE_ERROR_INVALID, and scree_world_destroy does nothing but log
// a warning.
typedef struct scree_draw_def
{
	uint32_t size;       // set by scree_draw_def_default
	uint32_t flags;      // bits of SCREE_DRAW_*; default SHAPES, SENSORS and JOINTS
	float impulse_scale; // m per N s: length of impulses, 0 to 1e6, default 0.1
	float speed_scale;   // s: length of velocities, 0 to 1e6, default 0.1
	float length;        // m: length of normals, axes and directions, 0 to SCREE_MAX_COORDINATE, default 0.25
	void* context;       // last argument of all functions; default null
	// A filled polygon of 3 to 8 vertices, convex and counter-clockwise, rounded by radius (m, 0: sharp).
	void (*polygon)(const scree_vec* vertices, int count, float radius, uint32_t color, void* context);
	// A filled circle; a line from its center shows its rotation.
	void (*circle)(scree_vec center, float radius, uint32_t color, void* context);
	// A filled capsule: all points whose distance from the line between a and b is at most radius.
	void (*capsule)(scree_vec a, scree_vec b, float radius, uint32_t color, void* context);
	void (*line)(scree_vec a, scree_vec b, uint32_t color, void* context);
	void (*point)(scree_vec at, float pixels, uint32_t color, void* context);    // pixels: suggested width, 3 to 6
	void (*text)(scree_vec at, const char* text, uint32_t color, void* context); // ASCII; at: lower left corner
} scree_draw_def;

// Returns a definition with the default values and without functions.
static inline scree_draw_def scree_draw_def_default(void);

// Draws the current state of a world, contacts and boxes of the last step. box (m): only things whose bounding boxes
// overlap it are drawn; it may be infinite; null: everything. Lines, points and texts are culled one by one. The order
// is that of the flags, and within each that of the slots; contacts have the order of scree_world_get_contacts. Thus
// the calls and their arguments are the same on every device. The world does not change. On failure no function has
// been called.
SCREE_API scree_status scree_world_draw(scree_world* world, const scree_draw_def* def, const scree_box* box);

typedef struct scree_collidable_state
{
	scree_collidable collidable;
	scree_body body; // null: the collidable belongs to no body
	scree_attribute attribute;
	scree_pose pose;          // pose of the shape in the world, as in scree_render_row
	const scree_shape* shape; // memory of the world, valid until the next call that changes the world
	uint64_t user;            // user data of the collidable
	uint32_t sensor;          // bits of SCREE_SENSOR_*
	scree_body_type type;     // type of the body; SCREE_BODY_STATIC without a body
	bool asleep, disabled;    // state of the body
} scree_collidable_state;

// Writes the states of up to capacity collidables in ascending index order, and sets count to their number: those whose
// bounding boxes overlap a box (m; it may be infinite), or all of them if box is null. Disabled bodies are included.
static inline scree_status scree_world_get_collidable_states(scree_world* world, const scree_box* box,
                                                             scree_collidable_state* states, int capacity, int* count);

// ---------------------------------------------------------------------------------------------------------------
// Versions
//
// The static inline functions above call the library functions below and pass the size of the struct in the program. A
// binding for another language calls the library functions directly. Members that the library does not have are set to
// 0.

SCREE_API void scree_world_def_default_sized(scree_world_def* def, size_t size);
static inline scree_world_def scree_world_def_default(void)
{
	scree_world_def def;
	scree_world_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API scree_status scree_world_get_def_sized(const scree_world* world, scree_world_def* def, size_t size);
static inline scree_status scree_world_get_def(const scree_world* world, scree_world_def* def)
{
	return scree_world_get_def_sized(world, def, sizeof *def);
}

SCREE_API scree_status scree_units_sized(scree_constant* constants, size_t size, int capacity, int* count);
static inline scree_status scree_units(scree_constant* constants, int capacity, int* count)
{
	return scree_units_sized(constants, sizeof *constants, capacity, count);
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

// Creates a body with a shape for the four functions below, as scree_body_create_with_shape does.
static inline scree_status scree_body_create_made(scree_world* world, scree_body_type type, scree_pose pose,
                                                  const scree_attribute_def* shape, uint64_t user, scree_body* body)
{
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.pose = pose;
	def.user = user;
	return scree_body_create_with_shape(world, &def, shape, body);
}
static inline scree_status scree_body_create_box(scree_world* world, scree_body_type type, scree_pose pose,
                                                 float half_width, float half_height, uint64_t user, scree_body* body)
{
	scree_attribute_def shape = scree_attribute_def_default();
	scree_status status = scree_shape_make_box(half_width, half_height, &shape.shape);
	return status == SCREE_OK ? scree_body_create_made(world, type, pose, &shape, user, body) : status;
}
static inline scree_status scree_body_create_circle(scree_world* world, scree_body_type type, scree_pose pose,
                                                    float radius, uint64_t user, scree_body* body)
{
	scree_attribute_def shape = scree_attribute_def_default();
	scree_vec center = {0.0f, 0.0f};
	scree_status status = scree_shape_make_circle(center, radius, &shape.shape);
	return status == SCREE_OK ? scree_body_create_made(world, type, pose, &shape, user, body) : status;
}
static inline scree_status scree_body_create_capsule(scree_world* world, scree_body_type type, scree_pose pose,
                                                     scree_vec a, scree_vec b, float radius, uint64_t user,
                                                     scree_body* body)
{
	scree_attribute_def shape = scree_attribute_def_default();
	scree_status status = scree_shape_make_capsule(a, b, radius, &shape.shape);
	return status == SCREE_OK ? scree_body_create_made(world, type, pose, &shape, user, body) : status;
}
static inline scree_status scree_body_create_polygon(scree_world* world, scree_body_type type, scree_pose pose,
                                                     const scree_vec* vertices, int count, float radius, uint64_t user,
                                                     scree_body* body)
{
	scree_attribute_def shape = scree_attribute_def_default();
	scree_status status = scree_shape_make_polygon(vertices, count, radius, &shape.shape);
	return status == SCREE_OK ? scree_body_create_made(world, type, pose, &shape, user, body) : status;
}

SCREE_API void scree_surface_default_sized(scree_surface* surface, size_t size);
static inline scree_surface scree_surface_default(void)
{
	scree_surface surface;
	scree_surface_default_sized(&surface, sizeof surface);
	return surface;
}

SCREE_API scree_status scree_collidable_get_surface_sized(const scree_world* world, scree_collidable collidable,
                                                          scree_surface* surface, size_t size);
static inline scree_status scree_collidable_get_surface(const scree_world* world, scree_collidable collidable,
                                                        scree_surface* surface)
{
	return scree_collidable_get_surface_sized(world, collidable, surface, sizeof *surface);
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

SCREE_API scree_status scree_snapshots_compare_sized(const void* a, size_t size_a, const void* b, size_t size_b,
                                                     scree_difference* differences, size_t size, int capacity,
                                                     int* count);
static inline scree_status scree_snapshots_compare(const void* a, size_t size_a, const void* b, size_t size_b,
                                                   scree_difference* differences, int capacity, int* count)
{
	return scree_snapshots_compare_sized(a, size_a, b, size_b, differences, sizeof *differences, capacity, count);
}

SCREE_API void scree_record_def_default_sized(scree_record_def* def, size_t size);
static inline scree_record_def scree_record_def_default(void)
{
	scree_record_def def;
	scree_record_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API scree_status scree_replay_get_info_sized(const scree_replay* replay, scree_replay_info* info, size_t size);
static inline scree_status scree_replay_get_info(const scree_replay* replay, scree_replay_info* info)
{
	return scree_replay_get_info_sized(replay, info, sizeof *info);
}

SCREE_API scree_status scree_world_get_counters_sized(scree_world* world, scree_counters* counters, size_t size);
static inline scree_status scree_world_get_counters(scree_world* world, scree_counters* counters)
{
	return scree_world_get_counters_sized(world, counters, sizeof *counters);
}

SCREE_API scree_status scree_batch_get_counters_sized(scree_batch* batch, scree_batch_counters* counters, size_t size);
static inline scree_status scree_batch_get_counters(scree_batch* batch, scree_batch_counters* counters)
{
	return scree_batch_get_counters_sized(batch, counters, sizeof *counters);
}

SCREE_API scree_status scree_batch_get_timings_sized(scree_batch* batch, scree_timings* timings, size_t size);
static inline scree_status scree_batch_get_timings(scree_batch* batch, scree_timings* timings)
{
	return scree_batch_get_timings_sized(batch, timings, sizeof *timings);
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

SCREE_API scree_status scree_body_get_def_sized(scree_world* world, scree_body body, scree_body_def* def, size_t size);
static inline scree_status scree_body_get_def(scree_world* world, scree_body body, scree_body_def* def)
{
	return scree_body_get_def_sized(world, body, def, sizeof *def);
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

SCREE_API scree_status scree_world_get_events_sized(scree_world* world,
                                                    scree_events* events); // the caller sets the sizes
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
                                                          scree_moved_bodies* list); // the caller sets the sizes
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

SCREE_API void scree_batch_def_default_sized(scree_batch_def* def, size_t size);
static inline scree_batch_def scree_batch_def_default(void)
{
	scree_batch_def def;
	scree_batch_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API void scree_channel_make_sized(scree_channel_kind kind, scree_channel* channel, size_t size);
static inline scree_channel scree_channel_make(scree_channel_kind kind)
{
	scree_channel channel;
	scree_channel_make_sized(kind, &channel, sizeof channel);
	return channel;
}

SCREE_API void scree_draw_def_default_sized(scree_draw_def* def, size_t size);
static inline scree_draw_def scree_draw_def_default(void)
{
	scree_draw_def def;
	scree_draw_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API scree_status scree_world_get_collidable_states_sized(scree_world* world, const scree_box* box,
                                                               scree_collidable_state* states, size_t size,
                                                               int capacity, int* count);
static inline scree_status scree_world_get_collidable_states(scree_world* world, const scree_box* box,
                                                             scree_collidable_state* states, int capacity, int* count)
{
	return scree_world_get_collidable_states_sized(world, box, states, sizeof *states, capacity, count);
}

#ifdef __cplusplus
}
#endif
#endif
