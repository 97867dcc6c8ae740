# What an installation holds, and the Debian package that ./package makes of it.

# The pages that help2man makes of what the program says about itself: one for the program, one for each verb.
function(stretch_manual folder)
  find_program(HELP2MAN help2man)
  if(NOT HELP2MAN)
    return()
  endif()
  add_custom_target(manual VERBATIM COMMENT "Writing the manual"
    COMMAND ${CMAKE_SOURCE_DIR}/third_party/manual.sh $<TARGET_FILE:stretch-engine> ${folder}/man)
  add_dependencies(manual stretch-engine)
  install(DIRECTORY ${folder}/man/ DESTINATION share/man/man1)
endfunction()

# The day of the newest commit, so that the same sources make the same package; without a repository today.
function(stretch_release_day)
  execute_process(COMMAND git -C ${CMAKE_SOURCE_DIR} log -1 --format=%cs OUTPUT_VARIABLE day OUTPUT_STRIP_TRAILING_WHITESPACE
                  ERROR_QUIET)
  if(NOT day)
    string(TIMESTAMP day "%Y-%m-%d" UTC)
  endif()
  set(STRETCH_RELEASE_DAY ${day} PARENT_SCOPE)
endfunction()

function(stretch_package)
  set(folder ${CMAKE_BINARY_DIR}/package-files)
  set(desktop ${CMAKE_SOURCE_DIR}/assets/desktop)
  stretch_release_day()
  configure_file(${desktop}/stretch-engine.metainfo.xml.in ${folder}/stretch-engine.metainfo.xml @ONLY)
  stretch_manual(${folder})

  install(TARGETS stretch-engine DESTINATION bin)
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/assets/ DESTINATION share/stretch-engine FILES_MATCHING PATTERN "*.glb" PATTERN "*.png"
          PATTERN "dummy" EXCLUDE PATTERN "shaders" EXCLUDE PATTERN "desktop" EXCLUDE)
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs/recipes DESTINATION share/stretch-engine)
  install(FILES ${desktop}/stretch-engine.desktop DESTINATION share/applications)
  install(FILES ${desktop}/stretch-engine.svg DESTINATION share/icons/hicolor/scalable/apps)
  install(FILES ${desktop}/stretch-engine.xml DESTINATION share/mime/packages)
  install(FILES ${folder}/stretch-engine.metainfo.xml DESTINATION share/metainfo)
  install(FILES ${CMAKE_SOURCE_DIR}/README.md DESTINATION share/doc/stretch-engine)
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs DESTINATION share/doc/stretch-engine)
  install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION share/doc/stretch-engine RENAME copyright)
  install(FILES ${CMAKE_SOURCE_DIR}/CHANGELOG.md DESTINATION share/doc/stretch-engine RENAME changelog)
endfunction()

# Packing builds nothing: ./package has built what it packs.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME stretch-engine)
set(CPACK_PACKAGE_CONTACT "The Stretch-Engine authors <maintainers@stretch-engine.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "make a realistic clip hit like a cartoon")
set(CPACK_PACKAGE_DESCRIPTION
    "Opens a rigged glTF character, shows the path of motion of a limb, stretches
it, and re-keys the clip with squash and stretch that every glTF viewer plays.
Gives limbs weight, adjusts clips by controllers, and turns simulated mesh
sequences into small skinned clips. Works in a window and, on whole libraries
of clips, without one.")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What is loaded while it runs, and so is not seen by the linker.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1, libegl1, libgl1-mesa-dri | libgl-driver, fonts-inter, fonts-font-awesome")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/third_party/debian_papers.cmake)
include(CPack)
