// SPDX-License-Identifier: MIT
// arithmetic_test.c -- tests the arithmetic of a device: one kernel computes 100,000 results of the operations in
// arithmetic.def, and the CPU the same. The CPU itself is tested by cpu/self_test.c.
//
// Devices may flush denormals to 0, since these decide no bit (docs/design/determinism.md). So results with a denormal operand
// or a denormal intermediate result only tell whether the device keeps them. Likewise a compiler may simplify operations
// with a constant 0. All other results must be equal, except for the bits of a NaN.
#include "opencl/arithmetic_test.h"
#include "backend/arithmetic.h"
#include "opencl/compile.h"
#include "platform/error.h"
#include "platform/processor.h"
#include <stdio.h>
#include <string.h>

#define LEAST_NORMAL 0x00800000u // bits of 2^-126; a result may also be flushed that only rounding makes as large

static _Thread_local bool denormal; // true: an operand or an intermediate result of the last case was denormal

static float noted(float x)
{
	unsigned bits;
	memcpy(&bits, &x, sizeof bits);
	bits &= 0x7fffffffu;
	denormal |= bits != 0 && bits <= LEAST_NORMAL;
	return x;
}

#define N(x) noted(x)
#include "opencl/arithmetic_item.h"

#define GROUP 64 // the number of work-items is a multiple of it

extern const char arithmetic_program[]; // text of the program, written by cmake/embed.cmake
extern const size_t arithmetic_program_length;

typedef enum
{
	RESULT_FLOAT,
	RESULT_WORD
} ResultType;

static const struct
{
	ResultType type;
	const char* text;
} operations[] = {
#define X(name, type, text, expression) {RESULT_##type, text},
#include "opencl/arithmetic.def"
#undef X
};

void arithmetic_options(bool own_rounding, char text[ARITHMETIC_OPTIONS])
{
	const Arithmetic* chosen = &arithmetic_setting;
	bool worse = chosen->rounding == ROUNDING_WORSE || chosen->rounding == ROUNDING_WRONG;
	snprintf(text, ARITHMETIC_OPTIONS, "%s%s%s%s", own_rounding ? " -DOWN_ROUNDING" : "",
	         worse ? " -DWORSE_ROUNDING" : "", chosen->fused ? " -DFUSED" : "",
	         chosen->flush ? " -cl-denorms-are-zero" : "");
}

typedef struct
{
	cl_context context;
	cl_command_queue queue;
	cl_program program;
	cl_kernel kernel;
	cl_mem buffer;
	cl_event event, unmapped; // events of the commands that map and unmap the buffer
	ContextFailure failure;
} Objects;

static scree_status compute(const Device* device, double limit, bool own_rounding, Objects* o, Word* results)
{
	cl_int error;
	cl_context_properties properties[] = {CL_CONTEXT_PLATFORM, (cl_context_properties)device->platform, 0};
	CREATE(&o->failure, o->context, error, Context, properties, 1, &device->id, NULL, NULL);
	TRY(context_check(&o->failure, "clCreateContext", error));
	CREATE(&o->failure, o->queue, error, CommandQueue, o->context, device->id, 0);
	TRY(context_check(&o->failure, "clCreateCommandQueue", error));

	char options[PROGRAM_OPTIONS], arithmetic[ARITHMETIC_OPTIONS];
	arithmetic_options(own_rounding, arithmetic);
	snprintf(options, sizeof options, "%s%s", device->type & CL_DEVICE_TYPE_CPU ? " -DCALLS" : "", arithmetic);
	TRY(program_build(&o->failure, o->context, device, options, arithmetic_program, arithmetic_program_length,
	                  &o->program));
	CREATE(&o->failure, o->kernel, error, Kernel, o->program, "arithmetic");
	TRY(context_check(&o->failure, "clCreateKernel", error));

	size_t bytes = ARITHMETIC_RESULTS * sizeof *results, items = (ARITHMETIC_RESULTS + GROUP - 1) / GROUP * GROUP;
	CREATE(&o->failure, o->buffer, error, Buffer, o->context, CL_MEM_WRITE_ONLY | CL_MEM_ALLOC_HOST_PTR, bytes, NULL);
	TRY(context_check(&o->failure, "clCreateBuffer", error));
	TRY(CALL(&o->failure, SetKernelArg, o->kernel, 0, sizeof o->buffer, &o->buffer));
	TRY(CALL(&o->failure, EnqueueNDRangeKernel, o->queue, o->kernel, 1, NULL, &items, NULL, 0, NULL, NULL));
	// the buffer is mapped, because a device that failed might write to `results` after its release
	void* mapped =
	    opencl.EnqueueMapBuffer(o->queue, o->buffer, CL_FALSE, CL_MAP_READ, 0, bytes, 0, NULL, &o->event, &error);
	TRY(context_check(&o->failure, "clEnqueueMapBuffer", error));
	TRY(CALL(&o->failure, Flush, o->queue));
	TRY(wait_for(&o->failure, o->event, limit, device->type & CL_DEVICE_TYPE_CPU));
	memcpy(results, mapped, bytes);
	TRY(CALL(&o->failure, EnqueueUnmapMemObject, o->queue, o->buffer, mapped, 0, NULL, &o->unmapped));
	TRY(CALL(&o->failure, Flush, o->queue));
	return wait_for(&o->failure, o->unmapped, limit, device->type & CL_DEVICE_TYPE_CPU);
}

static void release(Objects* o)
{
	RELEASE(&o->failure, Event, o->event);
	RELEASE(&o->failure, Event, o->unmapped);
	RELEASE(&o->failure, MemObject, o->buffer);
	RELEASE(&o->failure, Kernel, o->kernel);
	RELEASE(&o->failure, Program, o->program);
	RELEASE(&o->failure, CommandQueue, o->queue);
	RELEASE(&o->failure, Context, o->context);
}

static int print_value(char* text, size_t size, ResultType type, Word bits)
{
	return type == RESULT_FLOAT ? snprintf(text, size, "%a", (double)bits_float((int)bits))
	                            : snprintf(text, size, "%d", (int)bits);
}

static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || c == '_'; }

// Prints an operation with its operands, for instance "0x1.8p+3 / 0x1.4p+1".
static void print_operation(char* text, size_t size, int operation, int number)
{
	Operands o = operands_of(operation, number);
	const float operands[] = {o.a, o.b, o.c};
	const char* pattern = operations[operation].text;
	size_t used = 0;
	for (size_t k = 0; pattern[k] && used + 1 < size; ++k)
	{
		char c = pattern[k];
		bool alone = is_letter(c) && !(k > 0 && is_letter(pattern[k - 1])) && !is_letter(pattern[k + 1]);
		if (alone && c <= 'c')
			used += (size_t)print_value(text + used, size - used, RESULT_FLOAT, float_word(operands[c - 'a']));
		else if (alone)
			used += (size_t)snprintf(text + used, size - used, "0x%08x", float_word(operands[c - 'i']));
		else
		{
			text[used++] = c;
			text[used] = '\0';
		}
	}
}

static bool is_nan(Word bits) { return (bits & 0x7fffffffu) > 0x7f800000u; }
static bool is_zero(Word bits) { return (bits & 0x7fffffffu) == 0u; }

// Returns true for a result of a compiler that replaces a * 0 by 0, a + 0 by a or 0 - a by -a, as that of llvmpipe does:
// zeros have the wrong sign, and the product of an infinite number and 0 is no NaN.
static bool is_simplified(int operation, Word expected, Word got)
{
	if (operation < ARITHMETIC_TIMES_ZERO || operation > ARITHMETIC_ZERO_LESS)
		return false;
	return is_zero(got) && (is_zero(expected) || (operation == ARITHMETIC_TIMES_ZERO && is_nan(expected)));
}

int arithmetic_compare(const Word* results, Verdict* verdict)
{
	verdict->keeps_denormals = verdict->keeps_zeros = true;
	for (int i = 0; i < ARITHMETIC_RESULTS; ++i)
	{
		int operation = i / ARITHMETIC_CASES, number = i % ARITHMETIC_CASES;
		Operands o = operands_of(operation, number);
		denormal = false;
		noted(o.a);
		noted(o.b);
		noted(o.c);
		Word expected = arithmetic_result(operation, number), got = results[i];
		ResultType type = operations[operation].type;
		if (got == expected || (type == RESULT_FLOAT && is_nan(got) && is_nan(expected)))
			continue;
		bool simplified = is_simplified(operation, expected, got);
		verdict->keeps_zeros &= !simplified;
		verdict->keeps_denormals &= simplified || !denormal;
		if (denormal || simplified)
			continue;
		char text[74], ours[17], theirs[17]; // the longest operation has four operands of 16 characters
		print_operation(text, sizeof text, operation, number);
		print_value(ours, sizeof ours, type, expected);
		print_value(theirs, sizeof theirs, type, got);
		snprintf(verdict->difference, sizeof verdict->difference, "it computes %s as %s, the CPU as %s", text, theirs,
		         ours);
		return operation;
	}
	return ARITHMETIC_OPERATIONS;
}

static scree_status compute_and_compare(const Device* device, double limit, Verdict* verdict, Word* results,
                                        int* operation)
{
	Objects objects = {.context = NULL};
	scree_status status = compute(device, limit, verdict->own_rounding, &objects, results);
	release(&objects);
	TRY(status);
	FloatMode mode = float_mode_enter();
	*operation = arithmetic_compare(results, verdict);
	float_mode_leave(mode);
	verdict->results = ARITHMETIC_RESULTS;
	verdict->equal = *operation == ARITHMETIC_OPERATIONS;
	return SCREE_OK;
}

scree_status arithmetic_test(const Device* device, double limit, Verdict* verdict)
{
	*verdict = (Verdict){.own_rounding = device->own_rounding};
	Word* results = scree_allocate(ARITHMETIC_RESULTS * sizeof *results);
	if (!results)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d results of an OpenCL device", ARITHMETIC_RESULTS);
	int operation = 0;
	scree_status status = compute_and_compare(device, limit, verdict, results, &operation);
	if (status == SCREE_OK && !verdict->equal && operation >= ARITHMETIC_QUOTIENT && !verdict->own_rounding)
	{
		log_sentence(SCREE_LOG_WARNING,
		             "%s reports that it rounds quotients and roots correctly, but %s; integers will round them.",
		             device->about.name, verdict->difference);
		*verdict = (Verdict){.own_rounding = true};
		status = compute_and_compare(device, limit, verdict, results, &operation);
	}
	scree_release(results);
	return status;
}
