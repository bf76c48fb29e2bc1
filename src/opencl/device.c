// SPDX-License-Identifier: MIT
// device.c -- lists OpenCL devices, checks which features they support, and adds stored verdicts.
#include "opencl/device.h"
#include "backend/arithmetic.h"
#include "backend/solve_form.h"
#include "backend/tables.h"
#include "opencl/group_sizes.h"
#include "platform/error.h"
#include "platform/system.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

#define MAX_PLATFORMS 16

// Bound of the size of all arguments of a kernel, bytes: a buffer or an offset, and a capacity, for each kind of
// item; the step; a run; 64 bytes for those of the relay, the tiles and the persistent kernel. OpenCL 1.2 guarantees
// 1,024.
#define ARGUMENT_BYTES \
	(BUFFERS * sizeof(cl_mem) + (2 * PER_COUNT - BUFFERS) * sizeof(int) + sizeof(Step) + sizeof(Run) + 64)
_Static_assert(ARGUMENT_BYTES <= 1024, "the arguments of a kernel exceed the minimum of OpenCL 1.2");

#define NO_PLATFORM (-1001) // CL_PLATFORM_NOT_FOUND_KHR of cl_khr_icd
#define DEVICE_UUID 0x106a  // a constant of cl_khr_device_uuid, which OpenCL 1.2 headers lack

#define DEFAULT_TIMEOUT 10.0 // s: limit of a wait for a GPU; a spin-wait of its kernels ends after 2 s

static _Thread_local char list_error[160]; // error of the last list of devices; empty: none

static void note_error(Device* d, const char* function, cl_int error)
{
	if (!d->error)
		d->error_function = function;
	d->error = d->error ? d->error : error;
}

static void platform_text(Device* d, cl_platform_info what, char* text, size_t size)
{
	char whole[1024] = "";
	note_error(d, "clGetPlatformInfo", opencl.GetPlatformInfo(d->platform, what, sizeof whole, whole, NULL));
	snprintf(text, size, "%.*s", (int)size - 1, whole);
}

static void device_text(Device* d, cl_device_info what, char* text, size_t size)
{
	char whole[1024] = "";
	note_error(d, "clGetDeviceInfo", opencl.GetDeviceInfo(d->id, what, sizeof whole, whole, NULL));
	const char* start = whole + strspn(whole, " ");
	snprintf(text, size, "%.*s", (int)size - 1, start);
}

// Returns a number that describes a device, or 0 if the query fails.
static cl_ulong device_number(Device* d, cl_device_info what)
{
	cl_ulong number = 0; // little-endian: a 32-bit answer fills the low half
	note_error(d, "clGetDeviceInfo", opencl.GetDeviceInfo(d->id, what, sizeof number, &number, NULL));
	return number;
}

static void find_sharing(Device* d)
{
	char extensions[8192] = "";
	note_error(d, "clGetDeviceInfo",
	           opencl.GetDeviceInfo(d->id, CL_DEVICE_EXTENSIONS, sizeof extensions, extensions, NULL));
	d->shares_opengl = strstr(extensions, "cl_khr_gl_sharing");
	d->shares_memory = strstr(extensions, "cl_khr_external_memory_opaque_fd");
	d->about.sharing = d->shares_opengl   ? SCREE_SHARING_OPENGL
	                   : d->shares_memory ? SCREE_SHARING_MEMORY
	                                      : SCREE_SHARING_COPIED;
	if (strstr(extensions, "cl_khr_device_uuid"))
		note_error(d, "clGetDeviceInfo",
		           opencl.GetDeviceInfo(d->id, DEVICE_UUID, sizeof d->about.uuid, d->about.uuid, NULL));
}

bool device_own_rounding(const Device* device)
{
	Rounding chosen = arithmetic_setting.rounding;
	return !device->correct_division || chosen == ROUNDING_OWN || chosen == ROUNDING_WORSE;
}

// Finds out whether a device is usable. If not, writes the reason to about.reason. The device's description of its
// arithmetic refuses no device, because it may be wrong; it decides only which words are tested first.
static void check_support(Device* d)
{
	char* reason = d->about.reason;
	size_t size = sizeof d->about.reason;
	char version[128];
	device_text(d, CL_DEVICE_VERSION, version, sizeof version);
	int major = 0, minor = 0;
	sscanf(version, "OpenCL %d.%d", &major, &minor);
	size_t most = (size_t)device_number(d, CL_DEVICE_MAX_PARAMETER_SIZE);
	d->local_memory = (size_t)device_number(d, CL_DEVICE_LOCAL_MEM_SIZE);
	cl_ulong floats = device_number(d, CL_DEVICE_SINGLE_FP_CONFIG);
	d->correct_division = floats & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT;
	d->own_rounding = device_own_rounding(d);

	d->usable = false;
	bool available = device_number(d, CL_DEVICE_AVAILABLE), compiler = device_number(d, CL_DEVICE_COMPILER_AVAILABLE);
	bool little = device_number(d, CL_DEVICE_ENDIAN_LITTLE);
	size_t group = (size_t)device_number(d, CL_DEVICE_MAX_WORK_GROUP_SIZE);
	if (d->error)
		snprintf(reason, size, "its driver does not describe it: %s: %s (%d)", d->error_function,
		         opencl_error_name(d->error), (int)d->error);
	else if (major * 10 + minor < 12)
		snprintf(reason, size, "it offers only %.40s; Scree needs OpenCL 1.2", version);
	else if (!available)
		snprintf(reason, size, "its driver says that it is not available");
	else if (!compiler)
		snprintf(reason, size, "its driver has no compiler");
	else if (!little)
		snprintf(reason, size, "it is big-endian");
	else if (most < ARGUMENT_BYTES)
		snprintf(reason, size, "it takes %zu bytes of kernel arguments; Scree needs %zu", most, ARGUMENT_BYTES);
	else if (d->local_memory < LOCAL_LEAST)
		snprintf(reason, size, "it has %zu bytes of local memory; Scree needs %d", d->local_memory, LOCAL_LEAST);
	else if (group < PRIMITIVE_GROUP)
		snprintf(reason, size, "its work-groups hold fewer than %d items", PRIMITIVE_GROUP);
	else
		d->usable = true;
	d->about.equal_bits = d->usable;
}

double device_wait_limit(const Device* device, const BackendOptions* options)
{
	if (options->device_timeout > 0.0f)
		return (double)options->device_timeout;
	// a CPU is never lost, and compiles kernels at their first launch, which may take minutes
	return device->type & CL_DEVICE_TYPE_CPU ? INFINITY : DEFAULT_TIMEOUT;
}

void device_judge(Device* device, const Verdict* verdict)
{
	scree_device* about = &device->about;
	device->own_rounding = verdict->own_rounding;
	about->tested = true;
	about->tested_results = verdict->results;
	about->tested_worlds = verdict->worlds;
	about->own_rounding = verdict->own_rounding;
	about->keeps_denormals = verdict->keeps_denormals;
	about->keeps_zeros = verdict->keeps_zeros;
	about->equal_bits = verdict->equal;
	if (!verdict->equal)
		snprintf(about->reason, sizeof about->reason, "%s; scree_world_def.allow_unequal_bits runs it anyway",
		         verdict->difference);
}

static void find_verdict(Device* d)
{
	// programs for CPUs have the kernels of all forms, or of none; programs for GPUs only if a form needs them
	d->verdict_key = verdict_key(d->identity, solve_form_setting == FORM_LAUNCHES && !(d->type & CL_DEVICE_TYPE_CPU));
	Verdict verdict;
	if (d->usable && verdict_read(d->verdict_key, &verdict))
		device_judge(d, &verdict);
}

static void describe(cl_platform_id platform, cl_device_id id, Device* d)
{
	*d = (Device){.platform = platform, .id = id};
	char version[128], driver[128], platform_version[128];
	device_text(d, CL_DEVICE_NAME, d->name, sizeof d->name);
	device_text(d, CL_DEVICE_VERSION, version, sizeof version);
	device_text(d, CL_DRIVER_VERSION, driver, sizeof driver);
	platform_text(d, CL_PLATFORM_NAME, d->platform_name, sizeof d->platform_name);
	platform_text(d, CL_PLATFORM_VERSION, platform_version, sizeof platform_version);
	snprintf(d->about.driver, sizeof d->about.driver, "%.60s, driver %.50s", d->platform_name, driver);
	snprintf(d->identity, sizeof d->identity, "%s|%s|%s|%s|%s", d->platform_name, platform_version, d->name, version,
	         driver);
	d->type = device_number(d, CL_DEVICE_TYPE);
	d->compiles_at_launch = strcmp(d->platform_name, "Portable Computing Language") == 0;
	d->about.compute_units = (int)device_number(d, CL_DEVICE_MAX_COMPUTE_UNITS);
	d->about.memory = device_number(d, CL_DEVICE_GLOBAL_MEM_SIZE);
	find_sharing(d);
	check_support(d);
}

// Writes the name of a device in a list, which no device before it has: the second of equal GPUs is "opencl:NAME #2".
static void name_device(const Device* devices, Device* d)
{
	char number[16] = "";
	d->number = 1;
	for (const Device* other = devices; other < d; ++other)
		d->number += strcmp(other->name, d->name) == 0;
	if (d->number > 1)
		snprintf(number, sizeof number, " #%d", d->number);
	snprintf(d->about.name, sizeof d->about.name, "opencl:%s%s", d->name, number);
}

// Returns whether a list of platforms or devices was read. Writes an error other than an empty list to list_error.
static bool lists(const char* function, cl_int error)
{
	if (error && error != CL_DEVICE_NOT_FOUND && error != NO_PLATFORM)
		snprintf(list_error, sizeof list_error, "OpenCL lists no device: %s: %s (%d)", function,
		         opencl_error_name(error), (int)error);
	return error == CL_SUCCESS;
}

static int list(Device* devices, int capacity)
{
	cl_platform_id platforms[MAX_PLATFORMS];
	cl_uint platform_count = 0;
	if (!opencl_load() || !lists("clGetPlatformIDs", opencl.GetPlatformIDs(MAX_PLATFORMS, platforms, &platform_count)))
		return 0;
	int count = 0;
	for (cl_uint p = 0; p < platform_count && p < MAX_PLATFORMS; ++p)
	{
		cl_device_id ids[MAX_DEVICES];
		cl_uint id_count = 0;
		if (!lists("clGetDeviceIDs",
		           opencl.GetDeviceIDs(platforms[p], CL_DEVICE_TYPE_ALL, MAX_DEVICES, ids, &id_count)))
			continue;
		for (cl_uint i = 0; i < id_count && i < MAX_DEVICES; ++i, ++count)
		{
			if (count >= capacity)
				continue;
			describe(platforms[p], ids[i], &devices[count]);
			name_device(devices, &devices[count]);
		}
	}
	return count;
}

int device_list(Device* devices, int capacity)
{
	// worlds in two threads may list devices at once, and PoCL 3.1 crashes if its first queries come from two threads
	static Mutex mutex = MUTEX_OPEN;
	mutex_lock(&mutex);
	list_error[0] = '\0';
	int count = list(devices, capacity);
	mutex_unlock(&mutex);
	// without the lock, because the log of a damaged verdict may call the library
	for (int k = 0; k < count && k < capacity; ++k)
		find_verdict(&devices[k]);
	return count;
}

const char* device_hint(int count)
{
	if (count > 0)
		return "";
	if (!opencl_load())
		return "There is no OpenCL on this machine: install ocl-icd-libopencl1 and, for the CPU, pocl-opencl-icd "
		       "(Debian, Ubuntu), or the GPU vendor's driver.";
	if (list_error[0])
		return list_error;
	return "OpenCL is installed but has no device: install pocl-opencl-icd (Debian, Ubuntu) for the CPU, or the GPU "
	       "vendor's driver.";
}

int opencl_devices(scree_device* devices, int capacity)
{
	Device found[MAX_DEVICES];
	int count = device_list(found, MAX_DEVICES);
	for (int i = 0; i < count && i < capacity && i < MAX_DEVICES; ++i)
		devices[i] = found[i].about;
	return count < MAX_DEVICES ? count : MAX_DEVICES;
}

const char* opencl_hint(void) { return device_hint(device_list(NULL, 0)); }
