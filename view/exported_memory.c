// SPDX-License-Identifier: MIT
// exported_memory.c -- allocates device memory through Vulkan; OpenCL and OpenGL import this memory.
//
// OpenCL and OpenGL cannot export memory; Vulkan can. The Vulkan library is opened at run time and used for nothing
// else.
#include "view/exported_memory.h"
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#ifdef SCREE_HAVE_VULKAN
#define VK_NO_PROTOTYPES
#include <dlfcn.h>
#include <vulkan/vulkan.h>

// functions of a Vulkan instance; functions of a Vulkan device
#define INSTANCE_FUNCTIONS(X)             \
	X(EnumeratePhysicalDevices)           \
	X(GetPhysicalDeviceProperties2)       \
	X(GetPhysicalDeviceMemoryProperties)  \
	X(EnumerateDeviceExtensionProperties) \
	X(CreateDevice)                       \
	X(GetDeviceProcAddr)
#define DEVICE_FUNCTIONS(X)        \
	X(CreateBuffer)                \
	X(DestroyBuffer)               \
	X(GetBufferMemoryRequirements) \
	X(AllocateMemory)              \
	X(FreeMemory)                  \
	X(GetMemoryFdKHR)

typedef struct
{
	VkInstance instance;
	VkPhysicalDevice physical;
	VkDevice device;
#define X(name) PFN_vk##name name;
	INSTANCE_FUNCTIONS(X)
	DEVICE_FUNCTIONS(X)
#undef X
} Vulkan;

#define MAX_GPUS 16

// Returns the index of an allowed memory type that is local to the device; -1 if there is no such type.
static int own_memory(const VkPhysicalDeviceMemoryProperties* types, uint32_t allowed)
{
	for (uint32_t k = 0; k < types->memoryTypeCount; ++k)
		if ((allowed >> k & 1) && (types->memoryTypes[k].propertyFlags & VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT))
			return (int)k;
	return -1;
}

static const char* open_instance(Vulkan* v, void* library)
{
	PFN_vkGetInstanceProcAddr address = (PFN_vkGetInstanceProcAddr)dlsym(library, "vkGetInstanceProcAddr");
	PFN_vkCreateInstance create = address ? (PFN_vkCreateInstance)address(NULL, "vkCreateInstance") : NULL;
	VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_1};
	VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &application};
	if (!create || create(&info, NULL, &v->instance) != VK_SUCCESS)
		return "Vulkan does not start: no driver of it is installed";
#define X(name)                                               \
	v->name = (PFN_vk##name)address(v->instance, "vk" #name); \
	if (!v->name)                                             \
		return "the Vulkan library has no vk" #name;
	INSTANCE_FUNCTIONS(X)
#undef X
	return NULL;
}

static const char* choose_gpu(Vulkan* v, const uint8_t uuid[16])
{
	VkPhysicalDevice gpus[MAX_GPUS];
	uint32_t count = MAX_GPUS;
	if (v->EnumeratePhysicalDevices(v->instance, &count, gpus) < 0)
		return "Vulkan cannot list its devices";
	for (uint32_t k = 0; k < count; ++k)
	{
		VkPhysicalDeviceIDProperties id = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES};
		VkPhysicalDeviceProperties2 properties = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
		                                          .pNext = &id};
		v->GetPhysicalDeviceProperties2(gpus[k], &properties);
		if (memcmp(id.deviceUUID, uuid, sizeof id.deviceUUID) == 0)
			v->physical = gpus[k];
	}
	return v->physical ? NULL : "Vulkan has no device with the UUID of the world's device";
}

static const char* open_device(Vulkan* v)
{
	const char* extension = VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME;
	float priority = 1.0f;
	VkDeviceQueueCreateInfo queue = {
	    .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority};
	VkDeviceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
	                           .queueCreateInfoCount = 1,
	                           .pQueueCreateInfos = &queue,
	                           .enabledExtensionCount = 1,
	                           .ppEnabledExtensionNames = &extension};
	if (v->CreateDevice(v->physical, &info, NULL, &v->device) != VK_SUCCESS)
		return "the Vulkan driver has no VK_KHR_external_memory_fd";
#define X(name)                                                          \
	v->name = (PFN_vk##name)v->GetDeviceProcAddr(v->device, "vk" #name); \
	if (!v->name)                                                        \
		return "the Vulkan driver has no vk" #name;
	DEVICE_FUNCTIONS(X)
#undef X
	return NULL;
}

static const char* allocate(Vulkan* v, size_t bytes, ExportedMemory* out)
{
	// this buffer only supplies the size and the type of the memory, and is destroyed before the memory is allocated
	const VkExternalMemoryHandleTypeFlags kind = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
	VkExternalMemoryBufferCreateInfo external = {.sType = VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_BUFFER_CREATE_INFO,
	                                             .handleTypes = kind};
	VkBufferCreateInfo buffer = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
	                             .pNext = &external,
	                             .size = bytes,
	                             .usage = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
	                                      VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT};
	VkBuffer made;
	if (v->CreateBuffer(v->device, &buffer, NULL, &made) != VK_SUCCESS)
		return "Vulkan makes no buffer that could be exported";
	VkMemoryRequirements needs;
	VkPhysicalDeviceMemoryProperties types;
	v->GetBufferMemoryRequirements(v->device, made, &needs);
	v->DestroyBuffer(v->device, made, NULL);
	v->GetPhysicalDeviceMemoryProperties(v->physical, &types);
	int type = own_memory(&types, needs.memoryTypeBits);

	VkExportMemoryAllocateInfo export = {.sType = VK_STRUCTURE_TYPE_EXPORT_MEMORY_ALLOCATE_INFO, .handleTypes = kind};
	VkMemoryAllocateInfo memory = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
	                               .pNext = &export,
	                               .allocationSize = needs.size,
	                               .memoryTypeIndex = (uint32_t)type};
	VkDeviceMemory allocation;
	if (type < 0 || v->AllocateMemory(v->device, &memory, NULL, &allocation) != VK_SUCCESS)
		return "Vulkan has no memory left on the device";
	out->allocation = allocation;
	out->allocated = needs.size;
	VkMemoryGetFdInfoKHR file = {.sType = VK_STRUCTURE_TYPE_MEMORY_GET_FD_INFO_KHR,
	                             .memory = allocation,
	                             .handleType = (VkExternalMemoryHandleTypeFlagBits)kind};
	for (int k = 0; k < 2; ++k)
		if (v->GetMemoryFdKHR(v->device, &file, &out->files[k]) != VK_SUCCESS)
			return "Vulkan does not export its memory";
	return NULL;
}

// Vulkan stays open until the process ends: closing it made NVIDIA's driver 580 drop the thread's OpenGL context. One
// Vulkan device is enough, because OpenGL draws on one device.
static Vulkan vulkan;

static const char* open_vulkan(Vulkan* v, const uint8_t uuid[16])
{
	void* library = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
	if (!library)
		return "there is no Vulkan to allocate memory with: install libvulkan1 (Debian, Ubuntu)";
	const char* error = open_instance(v, library);
	if (!error)
		error = choose_gpu(v, uuid);
	return error ? error : open_device(v);
}

static const char* make(ExportedMemory* memory, const uint8_t uuid[16], size_t bytes)
{
	static const char* error;
	static uint8_t opened[16];
	static bool open;
	if (!open)
	{
		error = open_vulkan(&vulkan, uuid);
		memcpy(opened, uuid, sizeof opened);
		open = true;
	}
	if (error)
		return error;
	if (memcmp(opened, uuid, sizeof opened) != 0)
		return "Vulkan allocates memory on another device already";
	return allocate(&vulkan, bytes, memory);
}

static void drop(ExportedMemory* memory)
{
	if (memory->allocation)
		vulkan.FreeMemory(vulkan.device, memory->allocation, NULL);
}
#else
static const char* make(ExportedMemory* memory, const uint8_t uuid[16], size_t bytes)
{
	(void)memory;
	(void)uuid;
	(void)bytes;
	return "this build has no Vulkan to allocate memory with: install its headers (Debian, Ubuntu: libvulkan-dev)";
}
static void drop(ExportedMemory* memory) { (void)memory; }
#endif

bool exported_memory_make(ExportedMemory* memory, const uint8_t uuid[16], size_t bytes, char* sentence, size_t size)
{
	*memory = (ExportedMemory){.files = {-1, -1}};
	const char* error = make(memory, uuid, bytes);
	snprintf(sentence, size, "%s", error ? error : "");
	if (error)
		exported_memory_drop(memory);
	return !error;
}

void exported_memory_drop(ExportedMemory* memory)
{
	for (int k = 0; k < 2; ++k)
		if (memory->files[k] >= 0)
			close(memory->files[k]);
	drop(memory);
	*memory = (ExportedMemory){.files = {-1, -1}};
}
