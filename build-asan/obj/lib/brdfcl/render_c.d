/tmp/w3_cli/build-asan/obj/lib/brdfcl/render_c.o: lib/brdfcl/render_c.c \
 lib/brdfcl/render_job.h include/brdfcl/render.h include/brdf/status.h \
 include/brdfcl/api.h include/brdfcl/device.h include/brdfcl/image.h \
 include/brdfcl/scene.h lib/brdfcl/world.h lib/brdfcl/bvh.h \
 lib/brdfcl/scene.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 kernels/scene.h include/brdf/model.h include/brdf/choices.h \
 include/brdf/frame.h include/brdf/parameters.h include/brdf/models.h \
 include/brdf/model/diffuse.h include/brdf/model/../parameters.h \
 include/brdf/model/../sample.h include/brdf/model/../warp.h \
 include/brdf/model/../math.h include/brdf/model/../real.h \
 include/brdf/model/../dialect.h include/brdf/model/../trigonometry.h \
 include/brdf/model/../exponential.h include/brdf/model/../erf.h \
 include/brdf/model/../vec.h include/brdf/model/phong.h \
 include/brdf/model/../frame.h include/brdf/model/blinnphong.h \
 include/brdf/model/../halfvector.h include/brdf/model/../mixture.h \
 include/brdf/model/../sample.h include/brdf/model/../warp.h \
 include/brdf/model/ward.h include/brdf/model/ashikhminshirley.h \
 include/brdf/model/torrancesparrow.h include/brdf/model/../fresnel.h \
 include/brdf/model/../vcavity.h include/brdf/model/../halfvector.h \
 include/brdf/model/cooktorrance.h include/brdf/model/abc.h \
 include/brdf/model/roughconductor.h include/brdf/model/../energy.h \
 include/brdf/model/../energy_fit.h include/brdf/model/../facets.h \
 include/brdf/model/../microfacet.h include/brdf/model/../vcavity.h \
 include/brdf/model/../round.h include/brdf/model/dielectric.h \
 include/brdf/model/conductor.h include/brdf/model/thindielectric.h \
 include/brdf/model/roughdielectric.h include/brdf/model/../facet.h \
 include/brdf/model/../interface.h include/brdf/model/../fresnel.h \
 include/brdf/model/../glass.h include/brdf/model/../glass_curve.h \
 include/brdf/model/../round.h include/brdf/model/plastic.h \
 include/brdf/model/../interface.h include/brdf/model/orennayar.h \
 include/brdf/model/../azimuth.h include/brdf/model/../cltc.h \
 include/brdf/model/lommelseeliger.h include/brdf/model/../regolith.h \
 include/brdf/model/hapke.h include/brdf/model/../henyeygreenstein.h \
 include/brdf/model/roughplastic.h include/brdf/model/../coating.h \
 include/brdf/model/principled.h include/brdf/model/../disney.h \
 include/brdf/model/../microfacet.h include/brdf/model/wood.h \
 include/brdf/model/../fiber.h include/brdf/model/../frame.h \
 include/brdf/model/merl.h include/brdf/model/measuredmix.h \
 include/brdf/model/merl.h include/brdf/model/measured.h \
 include/brdf/model/../math.h include/brdf/model/../measurement.h \
 include/brdf/model/../warp2d.h include/brdf/model/../quad.h \
 kernels/texture_record.h lib/brdfcl/world_words.h kernels/path.h \
 kernels/lanes.h include/brdf/dialect.h kernels/random.h kernels/rows.h \
 include/brdf/quad.h include/brdf/vec.h kernels/scene.h kernels/connect.h \
 kernels/extend.h kernels/bvh.h kernels/bvh_leaf.h kernels/intersect.h \
 kernels/path.h kernels/film.h kernels/generate.h include/brdf/math.h \
 kernels/resolve.h kernels/texture.h kernels/interaction.h \
 kernels/texture_bitmap.h kernels/texture_record.h kernels/woodgrain.h \
 kernels/meeting.h kernels/shade.h include/brdf/surface.h \
 include/brdf/model.h kernels/light.h kernels/environment.h \
 include/brdf/warp.h kernels/search.h kernels/tilt.h \
 kernels/derivatives.h kernels/texture_gradient.h kernels/sort.h \
 kernels/through.h kernels/shade.h
lib/brdfcl/render_job.h:
include/brdfcl/render.h:
include/brdf/status.h:
include/brdfcl/api.h:
include/brdfcl/device.h:
include/brdfcl/image.h:
include/brdfcl/scene.h:
lib/brdfcl/world.h:
lib/brdfcl/bvh.h:
lib/brdfcl/scene.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
kernels/scene.h:
include/brdf/model.h:
include/brdf/choices.h:
include/brdf/frame.h:
include/brdf/parameters.h:
include/brdf/models.h:
include/brdf/model/diffuse.h:
include/brdf/model/../parameters.h:
include/brdf/model/../sample.h:
include/brdf/model/../warp.h:
include/brdf/model/../math.h:
include/brdf/model/../real.h:
include/brdf/model/../dialect.h:
include/brdf/model/../trigonometry.h:
include/brdf/model/../exponential.h:
include/brdf/model/../erf.h:
include/brdf/model/../vec.h:
include/brdf/model/phong.h:
include/brdf/model/../frame.h:
include/brdf/model/blinnphong.h:
include/brdf/model/../halfvector.h:
include/brdf/model/../mixture.h:
include/brdf/model/../sample.h:
include/brdf/model/../warp.h:
include/brdf/model/ward.h:
include/brdf/model/ashikhminshirley.h:
include/brdf/model/torrancesparrow.h:
include/brdf/model/../fresnel.h:
include/brdf/model/../vcavity.h:
include/brdf/model/../halfvector.h:
include/brdf/model/cooktorrance.h:
include/brdf/model/abc.h:
include/brdf/model/roughconductor.h:
include/brdf/model/../energy.h:
include/brdf/model/../energy_fit.h:
include/brdf/model/../facets.h:
include/brdf/model/../microfacet.h:
include/brdf/model/../vcavity.h:
include/brdf/model/../round.h:
include/brdf/model/dielectric.h:
include/brdf/model/conductor.h:
include/brdf/model/thindielectric.h:
include/brdf/model/roughdielectric.h:
include/brdf/model/../facet.h:
include/brdf/model/../interface.h:
include/brdf/model/../fresnel.h:
include/brdf/model/../glass.h:
include/brdf/model/../glass_curve.h:
include/brdf/model/../round.h:
include/brdf/model/plastic.h:
include/brdf/model/../interface.h:
include/brdf/model/orennayar.h:
include/brdf/model/../azimuth.h:
include/brdf/model/../cltc.h:
include/brdf/model/lommelseeliger.h:
include/brdf/model/../regolith.h:
include/brdf/model/hapke.h:
include/brdf/model/../henyeygreenstein.h:
include/brdf/model/roughplastic.h:
include/brdf/model/../coating.h:
include/brdf/model/principled.h:
include/brdf/model/../disney.h:
include/brdf/model/../microfacet.h:
include/brdf/model/wood.h:
include/brdf/model/../fiber.h:
include/brdf/model/../frame.h:
include/brdf/model/merl.h:
include/brdf/model/measuredmix.h:
include/brdf/model/merl.h:
include/brdf/model/measured.h:
include/brdf/model/../math.h:
include/brdf/model/../measurement.h:
include/brdf/model/../warp2d.h:
include/brdf/model/../quad.h:
kernels/texture_record.h:
lib/brdfcl/world_words.h:
kernels/path.h:
kernels/lanes.h:
include/brdf/dialect.h:
kernels/random.h:
kernels/rows.h:
include/brdf/quad.h:
include/brdf/vec.h:
kernels/scene.h:
kernels/connect.h:
kernels/extend.h:
kernels/bvh.h:
kernels/bvh_leaf.h:
kernels/intersect.h:
kernels/path.h:
kernels/film.h:
kernels/generate.h:
include/brdf/math.h:
kernels/resolve.h:
kernels/texture.h:
kernels/interaction.h:
kernels/texture_bitmap.h:
kernels/texture_record.h:
kernels/woodgrain.h:
kernels/meeting.h:
kernels/shade.h:
include/brdf/surface.h:
include/brdf/model.h:
kernels/light.h:
kernels/environment.h:
include/brdf/warp.h:
kernels/search.h:
kernels/tilt.h:
kernels/derivatives.h:
kernels/texture_gradient.h:
kernels/sort.h:
kernels/through.h:
kernels/shade.h:
