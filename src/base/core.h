// SPDX-License-Identifier: MIT
// Assertions, allocation and messages for the inside of the library.
#ifndef SOLE_BASE_CORE_H
#define SOLE_BASE_CORE_H

#include "sole/base.h"

/// Misuse: cheap, always compiled; the caller goes on to a safe refusal.
#define SOLE_ASSERT( condition ) ( ( condition ) ? (void)0 : soleReportAssert( #condition, __FILE__, __LINE__ ) )

void soleReportAssert( const char* condition, const char* file, int line );

/// Zeroed memory from the user's allocator (NULL: malloc), or NULL.
void* soleAlloc( const soleAllocator* allocator, size_t byteCount );
void soleFree( const soleAllocator* allocator, void* memory, size_t byteCount );

/// Formats a message for people. A NULL message is allowed.
void soleSetMessage( soleMessage* message, const char* format, ... )
#if defined( __GNUC__ )
    __attribute__( ( format( printf, 2, 3 ) ) )
#endif
    ;

#endif
