/tmp/w3_cli/build-asan/obj/cli/fit.o: cli/fit.c include/brdf/info.h \
 include/brdf/parameters.h include/brdf/choices.h include/brdf/vec.h \
 include/brdf/dialect.h include/brdf/status.h include/brdf/model.h \
 include/brdf/frame.h include/brdf/sample.h include/brdf/models.h \
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
 lib/brdflab/fit.h include/brdf/material.h lib/brdflab/open.h \
 include/brdf/merl.h lib/brdflab/plot.h lib/brdflab/section.h \
 lib/brdflab/scene_text.h cli/commands.h cli/fit_picture.h cli/measured.h \
 include/brdf/rgl.h cli/options.h cli/say.h include/brdf/status.h \
 cli/stop.h
include/brdf/info.h:
include/brdf/parameters.h:
include/brdf/choices.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/model.h:
include/brdf/frame.h:
include/brdf/sample.h:
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
lib/brdflab/fit.h:
include/brdf/material.h:
lib/brdflab/open.h:
include/brdf/merl.h:
lib/brdflab/plot.h:
lib/brdflab/section.h:
lib/brdflab/scene_text.h:
cli/commands.h:
cli/fit_picture.h:
cli/measured.h:
include/brdf/rgl.h:
cli/options.h:
cli/say.h:
include/brdf/status.h:
cli/stop.h:
