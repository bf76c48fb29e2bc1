// SPDX-License-Identifier: MIT
// external_memory.c -- shares memory with other programs on the device: render rows, queries, rows of batches.
//
// cl_khr_gl_sharing imports a buffer object of OpenGL into a context that was created for it; cl_khr_external_memory
// imports memory that Vulkan exported as a file descriptor. The memory must be acquired before each use and released
// after it. Only the kernel render_row writes to it directly. All others are copied within device
// memory, because their pools share a buffer with other pools.
#include "opencl/external_memory.h"
#include "opencl/launch.h"
#include "opencl/queue.h"
#include "platform/error.h"
#ifdef _WIN32
#include <io.h>
#define copy_file  _dup
#define close_file _close
#else
#include <unistd.h>
#define copy_file  dup
#define close_file close
#endif

#define MEMORY_OPAQUE_FD 0x2060 // value of cl_khr_external_memory, revision 1.0; OpenCL 1.2 headers do not define it

typedef cl_ulong MemoryProperty;
typedef cl_mem(CL_API_CALL* CreateFromFile)(cl_context, const MemoryProperty*, cl_mem_flags, size_t, void*, cl_int*);
typedef cl_mem(CL_API_CALL* CreateFromOpenGl)(cl_context, cl_mem_flags, cl_uint, cl_int*);

typedef struct // names of the functions that create, acquire and release shared memory
{
	const char *create, *acquire, *release;
} Extension;

static Extension extension_of(scree_sharing how)
{
	if (how == SCREE_SHARING_OPENGL)
		return (Extension){"clCreateFromGLBuffer", "clEnqueueAcquireGLObjects", "clEnqueueReleaseGLObjects"};
	return (Extension){"clCreateBufferWithProperties", "clEnqueueAcquireExternalMemObjectsKHR",
	                   "clEnqueueReleaseExternalMemObjectsKHR"};
}

static cl_mem import(OpenCl* d, void* create, const SharedMemory* memory, cl_int* error)
{
	if (memory->how == SCREE_SHARING_OPENGL)
		return ((CreateFromOpenGl)create)(d->context, CL_MEM_WRITE_ONLY, memory->buffer, error);
	int file = memory->copies_file ? copy_file(memory->file) : memory->file;
	MemoryProperty properties[] = {MEMORY_OPAQUE_FD, (MemoryProperty)file, 0};
	cl_mem made = ((CreateFromFile)create)(d->context, properties, CL_MEM_READ_WRITE, memory->bytes, NULL, error);
	if (*error && memory->copies_file && file >= 0)
		close_file(file);
	return made;
}

scree_status opencl_share(Backend* b, SharedUse use, const SharedMemory* memory)
{
	OpenCl* d = b->state;
	Shared made = {0};
	if (memory)
	{
		Extension extension = extension_of(memory->how);
		void* create = opencl_find(d->device.platform, extension.create);
		made.acquire = (ShareFunction)opencl_find(d->device.platform, extension.acquire);
		made.release = (ShareFunction)opencl_find(d->device.platform, extension.release);
		if (!create || !made.acquire || !made.release)
			return fail(SCREE_ERROR_NOT_SUPPORTED, "%s has no %s.", b->name,
			            !create         ? extension.create
			            : !made.acquire ? extension.acquire
			                            : extension.release);
		cl_int error = CL_SUCCESS;
		made.memory = import(d, create, memory, &error);
		if (context_note(d->failure, error))
			return context_check(d->failure, extension.create, error);
		if (error)
			return fail(SCREE_ERROR_NOT_SUPPORTED, "%s cannot import the shared memory: %s says %s (%d).", b->name,
			            extension.create, opencl_error_name(error), (int)error);
	}
	scree_status status = finish(d);
	cl_mem left = status == SCREE_OK ? d->shared[use].memory : made.memory;
	RELEASE(d->failure, MemObject, left);
	if (status == SCREE_OK)
		d->shared[use] = made;
	return status;
}

static scree_status acquire(OpenCl* d, const Shared* shared)
{
	return context_check(d->failure, "acquire of shared memory",
	                     context_failed(d->failure) ? context_error(d->failure)
	                                                : shared->acquire(d->queue, 1, &shared->memory, 0, NULL, NULL));
}

static scree_status release(OpenCl* d, const Shared* shared)
{
	return context_check(d->failure, "release of shared memory",
	                     context_failed(d->failure) ? context_error(d->failure)
	                                                : shared->release(d->queue, 1, &shared->memory, 0, NULL, NULL));
}

scree_status opencl_render(Backend* b, const Run* run)
{
	OpenCl* d = b->state;
	const Shared* shared = &d->shared[SHARED_ROWS];
	const Kernel* kernel = &d->kernels[run->kernel_id];
	TRY(acquire(d, shared));
	TRY(CALL(d->failure, SetKernelArg, kernel->kernel, (cl_uint)d->argument[PER_RENDER_ROW], sizeof(cl_mem),
	         &shared->memory));
	TRY(kernel_run(d, run));
	TRY(kernel_bind(d, PER_RENDER_ROW, kernel));
	TRY(release(d, shared));
	return finish(d);
}

// Returns the offset of an item of a pool in the buffer of the pool, bytes.
static size_t item_offset(const OpenCl* d, PoolId pool, int first)
{
	return pool_offset(d, pool) + pool_info[pool].bytes * (size_t)first;
}

scree_status opencl_download(Backend* b, SharedUse use, PoolId pool, int first, int count, size_t offset)
{
	OpenCl* d = b->state;
	const Shared* shared = &d->shared[use];
	TRY(acquire(d, shared));
	TRY(CALL(d->failure, EnqueueCopyBuffer, d->queue, shared->memory, pool_buffer(d, pool), offset,
	         item_offset(d, pool, first), pool_info[pool].bytes * (size_t)count, 0, NULL, NULL));
	return release(d, shared);
}

scree_status opencl_upload(Backend* b, SharedUse use, PoolId pool, int first, int count, size_t offset)
{
	OpenCl* d = b->state;
	const Shared* shared = &d->shared[use];
	TRY(acquire(d, shared));
	TRY(CALL(d->failure, EnqueueCopyBuffer, d->queue, pool_buffer(d, pool), shared->memory, item_offset(d, pool, first),
	         offset, pool_info[pool].bytes * (size_t)count, 0, NULL, NULL));
	TRY(release(d, shared));
	return finish(d);
}

void shared_close(OpenCl* d)
{
	for (int use = 0; use < SHARED_USES; ++use)
		RELEASE(d->failure, MemObject, d->shared[use].memory);
}

scree_status share_open_context(OpenCl* d, const scree_opengl* opengl)
{
	cl_int error;
	cl_context_properties plain[] = {CL_CONTEXT_PLATFORM, (cl_context_properties)d->device.platform, 0};
	if (opengl && d->device.shares_opengl)
	{
		// keys of cl_khr_gl_sharing: 0x2008 is CL_GL_CONTEXT_KHR; the key of the display depends on the window system
		static const cl_context_properties displays[] = {
		    [SCREE_WINDOW_EGL] = 0x2009, [SCREE_WINDOW_GLX] = 0x200a, [SCREE_WINDOW_WGL] = 0x200b};
		cl_context_properties shared[] = {0x2008,
		                                  (cl_context_properties)opengl->context,
		                                  displays[opengl->system],
		                                  (cl_context_properties)opengl->display,
		                                  plain[0],
		                                  plain[1],
		                                  0};
		CREATE(d->failure, d->context, error, Context, shared, 1, &d->device.id, NULL, NULL);
		if (!error)
		{
			d->backend->sharing = SCREE_SHARING_OPENGL;
			return SCREE_OK;
		}
	}
	CREATE(d->failure, d->context, error, Context, plain, 1, &d->device.id, NULL, NULL);
	return context_check(d->failure, "clCreateContext", error);
}
