"""What the pages of the laws say beyond the registrations: families, groups, symbols of the equations, materials of the examples."""

# family: (title, first paragraph of the list)
FAMILIES = {
    "eos": ("Equations of state",
            "An equation of state gives the pressure of a material as a function of its density $\\rho$ and specific internal energy $e$. "
            "Choose one for each material: `law = \"...\"` in the table `[material.NAME.eos]` of a deck. Its *reference state* has the "
            "density $\\rho_0$, zero pressure and the temperature $T_0$. Two kinds of material differ: the reference pressure of a gas is "
            "not zero, and the reference state of detonation products has the density and energy of the unreacted explosive.\n\n"
            "Each page states the limits of its formulas. The command-line tools refuse a state outside them with an error message that "
            "gives the limit. A run does not start outside them, and it stops when the sound speed of a zone is no longer real."),
    "strength": ("Strength",
                 "A strength law gives the shear modulus and the flow stress of a solid: `law = \"...\"` in the table "
                 "`[material.NAME.strength]` of a deck."),
    "fracture": ("Fracture",
                 "A fracture law decides when a material fails in tension, and how much tension it supports afterwards: `law = \"...\"` in "
                 "the table `[material.NAME.fracture]` of a deck."),
    "viscosity": ("Artificial viscosity",
                  "Artificial viscosity spreads a shock over a few zones: `law = \"...\"` in the table `[solver.viscosity]` of a deck. "
                  "The laws give the viscous pressure as $q = \\rho\\,|\\Delta u|\\,w$, with the velocity difference $\\Delta u$ across a "
                  "zone and a velocity $w$ that depends on the law."),
    "burn": ("Burning",
             "A burn law turns an explosive into its products, at set times or at a rate that depends on the state: `law = \"...\"` in "
             "the table `[material.NAME.burn]` of a deck."),
    "mixture": ("Mixtures",
                "A mixture law gives the state of reactants and products that share a zone while the explosive burns: `mixture = \"...\"` "
                "in the table `[material.NAME]` of a deck. See [mixtures of reactants and products](../../theory/mixtures.md)."),
    "transport": ("Physical viscosity",
                  "Shear viscosity of a fluid, for the structure of a shock and for the solver `lagrange1d`: "
                  "`viscosity = {law = \"...\", ...}` in the table `[transport.NAME]` of a deck, where NAME is a material, or in "
                  "`[solver.transport]` for the solver `shock_structure`."),
    "conduction": ("Heat conduction",
                   "Thermal conductivity of a material, for the structure of a shock and for the solver `lagrange1d`: "
                   "`conduction = {law = \"...\", ...}` in the table `[transport.NAME]` of a deck, where NAME is a material, or in "
                   "`[solver.transport]` for the solver `shock_structure`."),
}
# of the equations of state; a law that is not named here is listed under the last title
GROUPS = {
    "Solids and liquids, from shock data": ("mie_gruneisen", "mie_gruneisen_linear_gamma", "mie_gruneisen_quadratic", "mie_gruneisen_cubic",
                                            "mie_gruneisen_cold", "mie_gruneisen_cold_series", "tillotson", "polynomial",
                                            "herrmann_series", "wilkins_cubic", "shock_energy"),
    "Solids and liquids, from static or ultrasonic data": ("birch_murnaghan", "murnaghan", "vinet", "tait", "stiffened_gas"),
    "Gases": ("ideal_gas", "power_law"),
    "Detonation products": ("jwl", "davis_products", "nonideal_gas"),
    "Unreacted explosives": ("jwl_unreacted", "jwl_proportional", "davis_reactants"),
    "Porous materials and powders": ("p_alpha", "p_lambda", "snow_plough", "grain_contact"),
    "Tables": ("table",),
    "Laws that modify another law": ("ambient", "shifted_energy", "temperature_power", "tension_cutoff"),
    "Others": (),
}
# parameter: symbol in the equations, of every equation of state or of one
SYMBOLS = {
    "rho0": r"\rho_0", "c0": "c_0", "s": "s", "s1": "s_1", "s2": "s_2", "s3": "s_3", "gamma0": r"\Gamma_0", "gamma_slope": r"\Gamma_1",
    "specific_heat": "c_v", "reference_temperature": "T_0", "bulk_modulus": "K_0", "bulk_modulus_slope": "K_0'", "omega": r"\omega",
    "rho_porous": r"\rho_{00}", "gamma": r"\gamma", "alpha": r"\alpha", "beta": r"\beta",
    "e0": "e_0", "a": "a", "b": "b", "c": "c", "d": "d", "k": "k", "n": "n", **{f"{x}{n}": f"{x}_{n}" for x in "kh" for n in range(4)},
}
_JWL = {"a": "A", "b": "B", "r1": "R_1", "r2": "R_2"}
OWN_SYMBOLS = {
    "ambient": {"pressure": "p_a", "energy": "e_a"},
    "davis_products": {"pc": "p_c", "vc": "v_c"},
    "davis_reactants": {"a": "A", "b": "B", "c": "C", "z": "Z", "specific_heat": "c_{v0}"},
    "grain_contact": {"grain_density": r"\rho_s", "grain_modulus": "K", "grain_modulus_slope": "n"},
    "jwl": {**_JWL, "e0": "E_0"},
    "jwl_proportional": _JWL,
    "jwl_unreacted": _JWL,
    "mie_gruneisen_cold": {"cold_energy": "E_{00}"},
    "mie_gruneisen_cold_series": {"cold_energy": "E_{00}", "order": "N"},
    "murnaghan": {"exponent": "n"},
    "nonideal_gas": {"rho1": r"\rho_1", "p1": "p_1", "gamma": r"\Gamma", "e0": "E_0", "reference_temperature": "T_1"},
    "p_alpha": {"alpha0": r"\alpha_0", "elastic_pressure": "p_e", "compaction_pressure": "p_s"},
    "p_lambda": {"matrix_modulus": "K", "crush_strength": "Y", "exponent": "n"},
    "power_law": {"p0": "p_0"},
    "shifted_energy": {"shift": r"\Delta e"},
    "snow_plough": {"crush_pressure": "p_c"},
    "stiffened_gas": {"p_infinity": r"P_\infty"},
    "table": {"least_sound_speed": "c_m"},
    "tait": {"b": "B", "c": "C"},
    "temperature_power": {"exponent": "w"},
    "tension_cutoff": {"tension": r"p_\text{cut}"},
    "tillotson": {"bulk_a": "A", "bulk_b": "B", "e0": "E_0", "e_incipient": "E_{iv}", "e_complete": "E_{cv}"},
}
# law: name of the material in its example; else that of the family
MATERIALS = {
    "strength": "copper", "fracture": "aluminium", "burn": "explosive", "eos": "aluminium",
    "constant_poisson": "aluminium", "perfectly_plastic": "aluminium", "steinberg_guinan": "aluminium", "herrmann": "aluminium",
    "ignition_growth": "lx_17",
    "birch_murnaghan": "iron", "davis_products": "pbx_9502", "davis_reactants": "pbx_9502", "grain_contact": "silica_powder",
    "ideal_gas": "air", "jwl": "tnt", "jwl_proportional": "explosive", "jwl_unreacted": "lx_17", "mie_gruneisen_cold": "copper",
    "mie_gruneisen_cold_series": "copper", "mie_gruneisen_cubic": "lead", "mie_gruneisen_quadratic": "iron", "nonideal_gas": "explosive",
    "p_alpha": "porous_aluminium", "p_lambda": "porous_aluminium", "power_law": "air", "shock_energy": "explosive",
    "snow_plough": "porous_aluminium", "stiffened_gas": "water", "tait": "water", "temperature_power": "explosive", "vinet": "copper",
    "wilkins_cubic": "copper",
}
CAPTIONS = {"table": "The figure shows a coarse table that was computed with the law `mie_gruneisen` for aluminium."}
# decks of laws whose parameters do not keep what a deck gives
WRITTEN = {
    "mie_gruneisen_cold_series": ('[material.copper.eos]', 'law = "mie_gruneisen_cold_series"', 'rho0 = "8930 kg/m^3"', 'c0 = "3940 m/s"',
                                  's = 1.49', 'gamma0 = 1.99', 'order = 4', 'cold_energy = "-114787.75 J/kg"',
                                  'specific_heat = "385 J/kg/K"'),
    "table": ('[material.metal.eos]', 'law = "table"', 'density = ["2700 kg/m^3", "2800 kg/m^3", "2900 kg/m^3"]',
              'temperatures = ["200 K", "300 K", "1000 K"]',
              '# three temperatures for each density', 'pressure_table = ["-3 GPa", "-2.5 GPa", "1 GPa", "-0.5 GPa", "0 GPa", "3.5 GPa", '
              '"2.2 GPa", "2.7 GPa", "6.2 GPa"]',
              'energy_table = ["-50 kJ/kg", "40 kJ/kg", "670 kJ/kg", "-90 kJ/kg", "0 kJ/kg", "630 kJ/kg", "-60 kJ/kg", "30 kJ/kg", '
              '"660 kJ/kg"]'),
    "forest_fire": ('[material.explosive.burn]', 'law = "forest_fire"', 'coefficients = [-5.5, 48.0, -52.0]     # invented values',
                    'p_min = "3 GPa"', 'p_max = "35 GPa"'),
    "rate_table": ('[material.explosive.burn]', 'law = "rate_table"', '# invented values',
                   'pressures = ["2 GPa", "5 GPa", "10 GPa", "20 GPa", "40 GPa"]',
                   'rates = ["2e3 1/s", "8e4 1/s", "1.2e6 1/s", "1.5e7 1/s", "1e8 1/s"]'),
}
# parameter of a mixture law: what gives it
WHERE_SET = {
    "reactants": "the table `unreacted` of the material", "products": "the table `eos` of the material",
    "detonation_energy": "the key `detonation_energy` of the material; default: the energy that the equation of state of the "
                         "products assigns to its reference state, minus the corresponding energy of the reactants",
    "reactant_density_limit": "the equation of state itself", "product_density_limit": "the equation of state itself",
    "nascent_limit": "the solver: 1e-3 with `lagrange1d` and `lagrange2d`, 1e-4 with `fronts`; 1e-6 in the tools without a mesh",
}
# mixture law: (key of the material that it reads besides its parameters, what gives it, meaning, value in the example)
KEYS_BESIDE = {
    "burned_products": ("detonation_energy", "the key `detonation_energy` of the material; default: the energy that the equation of state "
                        "of the products assigns to its reference state", "chemical energy Q released by burning", "5 MJ/kg"),
}
# law: (key of a deck that replaces the required parameters, its meaning, where the keys that go with it are described)
INSTEAD = {
    "table": ("file", "name of a file that holds the table, in place of the four arrays",
              "[Tables from files](../../../theory/eos_tools.md#tables-from-files) lists the keys that may accompany `file`."),
}
QUANTITIES = {      # variable: (name, unit shown, factor from SI)
    "rho": ("density", "kg/m³", 1.0), "e": ("specific internal energy", "MJ/kg", 1e-6), "p": ("pressure", "GPa", 1e-9),
    "temperature": ("temperature", "K", 1.0), "T": ("temperature", "K", 1.0), "bulk_modulus": ("bulk modulus", "GPa", 1e-9),
    "plastic_strain": ("plastic strain", "", 1.0), "du": ("velocity difference across a zone", "m/s", 1.0),
    "strain_rate": ("strain rate", "1/s", 1.0), "viscosity.v": ("specific volume", "m³/kg", 1.0),
    "tension": ("tension", "GPa", 1e-9), "v": ("relative volume", "", 1.0),
    "damage": ("damage", "", 1.0), "c": ("sound speed", "m/s", 1.0), "psi": ("smoothness of the flow (0 to 1)", "", 1.0),
    "burn_fraction": ("burn fraction", "", 1.0),
}
