/// Starts the page: the token first, then the theme, then what the address says.

import { listen } from "./api/client";
import { exchangeToken, takeToken } from "./api/session_token";
import { app, messageOf, tell } from "./app/state/app_state";
import { parseRoute } from "./app/state/route";
import { followTheme } from "./app/state/theme";
import "./app/shell/app";
import "./styles/index.css";

const token = takeToken(location, history);

listen({
  reached: (there) => app.set({ connected: there }),
  tokenWanted: () => app.set({ tokenWanted: true }),
});
followTheme();

async function start(): Promise<void> {
  if (token !== null) {
    try {
      await exchangeToken(token);
      app.set({ tokenWanted: false });
    } catch (error) {
      if (!app.value.tokenWanted) tell(messageOf(error));
    }
  }
  const follow = () => app.set({ route: parseRoute(location.hash) });
  addEventListener("hashchange", follow);
  follow();
  document.querySelector("sp-app")?.setAttribute("ready", "");
}

void start();
