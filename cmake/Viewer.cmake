# Builds the report's page from viewer/ with npm; the room `report` carries it inside the program.
find_program(NPM npm REQUIRED)
set(VIEWER ${CMAKE_SOURCE_DIR}/viewer)
set(WASHTUB_TEMPLATE ${CMAKE_BINARY_DIR}/viewer/index.html)
set(npm_installed ${VIEWER}/node_modules/.package-lock.json)
file(GLOB_RECURSE viewer_sources CONFIGURE_DEPENDS ${VIEWER}/src/*)

add_custom_command(OUTPUT ${npm_installed}
  COMMAND ${NPM} ci --no-audit --no-fund --loglevel=error
  COMMAND ${CMAKE_COMMAND} -E touch ${npm_installed}
  DEPENDS ${VIEWER}/package-lock.json WORKING_DIRECTORY ${VIEWER}
  COMMENT "Installing the viewer's packages" VERBATIM)
add_custom_command(OUTPUT ${WASHTUB_TEMPLATE}
  COMMAND ${NPM} run --silent build -- --outDir ${CMAKE_BINARY_DIR}/viewer --logLevel warn
  DEPENDS ${npm_installed} ${viewer_sources} ${VIEWER}/index.html ${VIEWER}/package.json
          ${VIEWER}/tsconfig.json ${VIEWER}/vite.config.ts
  WORKING_DIRECTORY ${VIEWER} COMMENT "Building the report's page" VERBATIM)
add_custom_target(viewer DEPENDS ${WASHTUB_TEMPLATE})
