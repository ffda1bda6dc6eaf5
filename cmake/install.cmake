# Headers, library, program, CMake package `sole` (target sole::sole) and pkg-config file `sole`. The installed tree may
# be moved as a whole: nothing in it names the place where it was installed.
include( GNUInstallDirs )
include( CMakePackageConfigHelpers )

set( SOLE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/sole )

install( DIRECTORY include/sole DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h" )
install( TARGETS sole EXPORT sole INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} )
install( EXPORT sole NAMESPACE sole:: FILE sole-config.cmake DESTINATION ${SOLE_CMAKE_DIR} )

write_basic_package_version_file( ${PROJECT_BINARY_DIR}/sole-config-version.cmake COMPATIBILITY SameMinorVersion )
install( FILES ${PROJECT_BINARY_DIR}/sole-config-version.cmake DESTINATION ${SOLE_CMAKE_DIR} )

# The prefix is found from where the .pc file lies.
file( RELATIVE_PATH SOLE_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig / )
string( REGEX REPLACE "/$" "" SOLE_PC_PREFIX "${SOLE_PC_PREFIX}" )
set( SOLE_PC_CFLAGS "" )
if( BUILD_SHARED_LIBS )
	set( SOLE_PC_CFLAGS " -DSOLE_SHARED" )
endif()
configure_file( cmake/sole.pc.in ${PROJECT_BINARY_DIR}/sole.pc @ONLY )
install( FILES ${PROJECT_BINARY_DIR}/sole.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig )

if( TARGET sole_program )
	if( BUILD_SHARED_LIBS AND NOT CMAKE_INSTALL_RPATH )
		file( RELATIVE_PATH SOLE_BIN_TO_LIB /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR} )
		set_target_properties( sole_program PROPERTIES INSTALL_RPATH "$ORIGIN/${SOLE_BIN_TO_LIB}" )
	endif()
	install( TARGETS sole_program )
	# The page that `sole report` fills, where scripts/build_report.sh has made it; the program looks for it from its own
	# place.
	install( FILES build/report/template.html DESTINATION ${CMAKE_INSTALL_BINDIR}/../share/sole RENAME report.html OPTIONAL )
endif()
