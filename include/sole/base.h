// SPDX-License-Identifier: MIT
// What every other header of Sole needs: export mark, results, version, hooks, allocator.
#ifndef SOLE_BASE_H
#define SOLE_BASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __FAST_MATH__
#error "Sole promises the same bits everywhere: build it without -ffast-math"
#endif

#ifdef __cplusplus
#define SOLE_EXTERN_C extern "C"
#else
#define SOLE_EXTERN_C
#endif

#if defined( _WIN32 ) && defined( SOLE_SHARED_EXPORT )
#define SOLE_API SOLE_EXTERN_C __declspec( dllexport )
#elif defined( _WIN32 ) && defined( SOLE_SHARED )
#define SOLE_API SOLE_EXTERN_C __declspec( dllimport )
#elif defined( __GNUC__ ) && defined( SOLE_SHARED_EXPORT )
#define SOLE_API SOLE_EXTERN_C __attribute__( ( visibility( "default" ) ) )
#else
#define SOLE_API SOLE_EXTERN_C
#endif

/// The version of these headers. soleGetVersion() tells that of the library that was linked.
#define SOLE_VERSION_MAJOR 0
#define SOLE_VERSION_MINOR 1
#define SOLE_VERSION_PATCH 0

/// Stands in `internalValue` of every definition made by a soleDefault function, so that a zeroed one is detected.
#define SOLE_COOKIE 0x501E001

/// No joint, no leg, no surface.
#define SOLE_NONE ( -1 )

typedef struct soleVersion
{
	int32_t major;
	int32_t minor;
	int32_t patch;
} soleVersion;

SOLE_API soleVersion soleGetVersion( void );

/// What a call that can be refused answers. Forced to 32 bits so that layouts agree between languages.
typedef enum soleResult
{
	sole_success = 0,
	sole_invalidDefinition, // a definition is not usable: the message names the field and the mend
	sole_outOfMemory,
	sole_notFound, // soleDetectRig: no legs in this skeleton
	sole_resultForce32 = 0x7fffffff
} soleResult;

/// A sentence for people: which field, what is wrong with it, how to mend it. Always terminated.
typedef struct soleMessage
{
	char text[256];
} soleMessage;

/// Where memory comes from. Used only by calls that create something; never per frame.
typedef struct soleAllocator
{
	/// @return memory aligned to 16 bytes, or NULL.
	void* ( *alloc )( size_t byteCount, void* user );
	/// byteCount is what alloc was asked for.
	void ( *free )( void* memory, size_t byteCount, void* user );
	void* user;
} soleAllocator;

/// Called when an assertion fails. Return true to break into the debugger (or abort), false to go on: the call is
/// then refused safely.
typedef bool soleAssertFcn( const char* condition, const char* file, int line );

/// Sets the handler of misuse for the whole process. NULL restores the default: print to stderr and abort in debug
/// builds, refuse silently in release builds (NDEBUG). Not thread safe: set it once, at start.
SOLE_API void soleSetAssertHandler( soleAssertFcn* handler );

#endif
