# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings of a FreeCAD that is driven by tests; run once in a fresh FREECAD_USER_HOME."""

import FreeCAD as App

PREFERENCES = "User parameter:BaseApp/Preferences/"
general = App.ParamGet(PREFERENCES + "General")
# The start page is a web view, which refuses to run as root and ends FreeCAD.
general.SetString("AutoloadModule", "NoneWorkbench")
general.SetBool("ShowSplasher", False)
App.ParamGet(PREFERENCES + "Mod/Start").SetBool("ShowOnStartup", False)
App.ParamGet(PREFERENCES + "Document").SetBool("RecoveryEnabled", False)
App.ParamGet(PREFERENCES + "Document").SetBool("AutoSaveEnabled", False)
App.saveParameter()
