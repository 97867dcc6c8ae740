# Run by CPack on the tree that it packs: the changelogs as Debian wants them. The project's own is packed, the package's
# names the version and points there.
set(papers ${CPACK_TEMPORARY_INSTALL_DIRECTORY}${CPACK_PACKAGING_INSTALL_PREFIX}/share/doc/stretch-engine)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${papers}/changelog.Debian
"stretch-engine (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Packed from the project's sources; changelog.gz says what changed.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
execute_process(COMMAND gzip -9nf ${papers}/changelog ${papers}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
